// The last part of a job: what was written is read back, held against what was meant, draped and judged.

#include <algorithm>
#include <cstdio>
#include <utility>

#include "cli/job.h"
#include "formats/formats.h"
#include "garment/units.h"
#include "workbench/judgement.h"

namespace toile {
namespace {

constexpr double reread_limit = 0.05e-3;  // m, a written outline read back

// The reread piece with its edges in the order of the piece that was written.
Piece in_order(const Piece& written, Piece read, double& moved) {
  const auto refuse = [&](const std::string& what) {
    throw BadInput({"export.changed", Severity::error, "piece '" + written.name + "'",
                    "the written DXF reads back differently: " + what,
                    "Do not cut from these files; please report this as a fault of the program", Fault::checks_failed});
  };
  if (read.outline.size() != written.outline.size())
    refuse(std::to_string(read.outline.size()) + " edges instead of " + std::to_string(written.outline.size()));
  const auto first =
      std::find_if(read.outline.begin(), read.outline.end(), [&](const Edge& e) { return e.id == written.outline.front().id; });
  if (first == read.outline.end()) refuse("no edge '" + written.outline.front().id + "'");
  std::rotate(read.outline.begin(), first, read.outline.end());
  for (std::size_t e = 0; e < written.outline.size(); ++e) {
    const Edge& a = written.outline[e];
    const Edge& b = read.outline[e];
    if (a.id != b.id || a.points.size() != b.points.size()) refuse("edge '" + a.id + "' has changed");
    for (std::size_t i = 0; i < a.points.size(); ++i) moved = std::max(moved, (a.points[i].at - b.points[i].at).norm());
  }
  if (read.notches.size() != written.notches.size()) refuse("the number of notches");
  return read;
}

Pattern in_order(const Pattern& written, const Pattern& read) {
  Pattern ordered = read;
  ordered.pieces.clear();
  double moved = 0;
  for (const Piece& piece : written.pieces) {
    const Piece* found = find_piece(read, piece.name);
    if (!found)
      throw BadInput({"export.changed", Severity::error, "piece '" + piece.name + "'", "the written DXF does not have it",
                      "Do not cut from these files; please report this as a fault of the program", Fault::checks_failed});
    ordered.pieces.push_back(in_order(piece, *found, moved));
  }
  if (moved > reread_limit)
    throw BadInput({"export.changed", Severity::error, "pattern", "the written DXF reads back " + in_mm(moved, 3) + " off",
                    "Do not cut from these files; please report this as a fault of the program", Fault::checks_failed});
  return ordered;
}

}  // namespace

void prove(Job& job, const std::filesystem::path& dxf, const std::filesystem::path& seams, Progress& progress) {
  progress.begin("verify");
  const Pattern read = value_or_throw(read_pattern(dxf, {std::nullopt, seams}));
  job.reread = in_order(as_named_in_dxf(cut_pattern(job), job.sheet), read);
  Pattern worn = job.reread;
  std::erase_if(worn.pieces, [](const Piece& piece) { return !piece.sewn; });
  job.verified = verify(worn, job.target, job.adjustment.rest, job.scene, job.recipe.drape.tolerance, watched(progress));
  job.girths = girth_table(with_rest(job.target.garment, job.verified.rest), job.verified.drape.positions, job.scene.body.form);
  job.tailoring = tailoring_difference(job.target.garment, job.target.positions, job.verified.drape.positions);
  add(job, job.verified.report);
  add(job, judge({job.target, job.adjustment, job.verified, job.redrawn.seam_mismatch, job.tailoring, job.scene.body.form}));
  progress.end(in_mm(job.verified.step.hausdorff) + " (" + percent_of_height(job.verified.step.hausdorff, job) + ")");
}

void check_still_proved(const Job& job, const std::filesystem::path& dxf, const std::filesystem::path& seams) {
  const Pattern read = value_or_throw(read_pattern(dxf, {std::nullopt, seams}));
  if (in_order(as_named_in_dxf(cut_pattern(job), job.sheet), read) != job.reread)
    throw BadInput({"export.changed", Severity::error, dxf.filename().string(), "is not the pattern that was draped",
                    "Do not cut from these files; please report this as a fault of the program", Fault::checks_failed});
}

}  // namespace toile
