#include "cli/account.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/certificate.h"
#include "cli/exit_codes.h"
#include "garment/units.h"

namespace toile {
namespace {

std::string plain(const char* form, double value) {
  char text[64];
  std::snprintf(text, sizeof text, form, value);
  return text;
}

std::vector<ReportFact> inputs(const Job& job) {
  const Recipe& recipe = job.recipe;
  std::vector<ReportFact> facts;
  for (const InputHash& input : job.inputs) facts.push_back({input.role, in_short(input)});
  const std::vector<ReportFact> settings{
      {"mannequin", job.scene.body.form.name + ", " + plain("%.1f cm tall", job.scene.body.form.height * cm_per_m)},
      {"simulator", job.scene.simulator.name},
      {"edge length", in_mm(recipe.drape.edge_length)},
      {"tolerance", plain("%.0e", recipe.drape.tolerance)},
      {"program", std::string("toile ") + TOILE_VERSION}};
  facts.insert(facts.end(), settings.begin(), settings.end());
  for (const Edit& edit : recipe.edits) {
    std::string words;
    for (const auto& [name, value] : edit.arguments) words += (words.empty() ? "" : ", ") + name + " " + value;
    facts.push_back({"edit: " + edit.operation, words});
  }
  return facts;
}

std::vector<ReportFact> drape_facts(const Job& job) {
  const Drape& drape = job.worn.drape;
  return {{"triangles", std::to_string(triangle_count(job.worn.garment))},
          {"settled", drape.settled ? "yes" : "no"},
          {"unbalanced force / weight", plain("%.1e", drape.residual)},
          {"steps", std::to_string(drape.steps)},
          {"deepest inside the body", in_mm(drape.max_penetration, 2)},
          {"widest seam when sewn", in_mm(job.worn.seam_gap, 2)},
          {"cloth through cloth", std::to_string(drape.self_intersections) + " pairs of triangles"},
          {"turned over", std::to_string(drape.inverted_triangles) + " triangles"},
          {"every limb through its opening", job.worn.links_ok ? "yes" : "no"},
          {"dropped", in_mm(drape.slipped)},
          {"time", plain("%.1f s", drape.seconds)}};
}

std::vector<ReportFact> tailoring_facts(const TailoringDifference& tailoring) {
  return {{"re-drape against target: girth", plain("within %.2f %%", 100 * tailoring.girth)},
          {"re-drape against target: seams as they hang", "within " + in_mm(tailoring.seam_length)},
          {"re-drape against target: hem and other openings", "at the same height within " + in_mm(tailoring.level)}};
}

std::vector<SummaryGirth> girths(const Job& job) {
  std::vector<SummaryGirth> rows;
  for (const GirthRow& row : job.girths)
    rows.push_back({row.name, row.height, row.body, row.covered, row.garment, row.cloth, row.ease});
  return rows;
}

std::vector<ReportPicture> embedded(const std::vector<Picture>& pictures) {
  std::vector<ReportPicture> shown;
  for (const Picture& picture : pictures) shown.push_back({picture.caption, picture.png});
  return shown;
}

std::vector<ReportSeam> seams(const Job& job) {
  std::vector<ReportSeam> rows;
  const Pattern& before = edited_pattern(job);
  const Pattern& after = job.redrawn.pattern;
  for (const Seam& seam : before.seams) {
    ReportSeam row;
    row.name = seam.name.empty() ? seam.a.piece + "." + seam.a.edge + " - " + seam.b.piece + "." + seam.b.edge : seam.name;
    row.before_a = span_length(before, seam.a);
    row.before_b = span_length(before, seam.b);
    row.after_a = span_length(after, seam.a);
    row.after_b = span_length(after, seam.b);
    row.mismatch = std::abs(row.after_a - row.before_a / row.before_b * row.after_b);
    rows.push_back(row);
  }
  return rows;
}

std::vector<ReportEdge> edges(const Job& job) {
  std::vector<ReportEdge> rows;
  for (std::size_t p = 0; p < job.redrawn.pattern.pieces.size(); ++p) {
    const Piece& before = edited_pattern(job).pieces[p];
    const Piece& after = job.redrawn.pattern.pieces[p];
    for (std::size_t e = 0; e < after.outline.size(); ++e)
      rows.push_back({after.name, after.outline[e].id, length(before.outline[e]), length(after.outline[e]),
                      is_straight(after.outline[e]), static_cast<int>(after.outline[e].points.size())});
  }
  return rows;
}

}  // namespace

std::string verdict(const Job& job) {
  char words[512];
  const double h = job.scene.body.form.height;
  std::snprintf(words, sizeof words,
                "%s: off the target by %.1f mm (%.2f %% of height) as flattened, %.1f mm (%.2f %%) as adjusted, mean %.2f mm; "
                "seams match "
                "within %.2f mm",
                job.recipe.name.c_str(), job.flattened.hausdorff * mm_per_m, 100 * job.flattened.hausdorff / h,
                job.verified.step.hausdorff * mm_per_m, 100 * job.verified.step.hausdorff / h,
                job.verified.step.mean * mm_per_m, job.redrawn.seam_mismatch * mm_per_m);
  return words;
}

RunSummary summary_of_drape(const Job& job, const std::vector<std::string>& files) {
  RunSummary summary;
  summary.version = TOILE_VERSION;
  summary.recipe = job.recipe.name;
  summary.mannequin = {job.scene.body.form.name, job.scene.body.form.height};
  summary.garment = {job.pattern.name, triangle_count(job.worn.garment), static_cast<int>(job.worn.garment.panels.size())};
  summary.fabric = job.scene.fabric.name;
  summary.drape = job.worn.drape;
  summary.tolerance = job.recipe.drape.tolerance;
  summary.seam_gap = job.worn.seam_gap;
  summary.links_ok = job.worn.links_ok;
  summary.girths = girths(job);
  summary.findings = job.findings;
  summary.inputs = by_name(job.inputs);
  summary.files = files;
  summary.seconds = job.seconds;
  return summary;
}

RunSummary summary_of(const Job& job, const std::vector<std::string>& files) {
  const AdjustStep& proved = job.verified.step;
  RunSummary summary = summary_of_drape(job, files);
  summary.verdict = verdict(job);
  summary.certificate = certificate(job);
  summary.ok = exit_code(job) == exit_ok;
  summary.flattened = {job.flattened.hausdorff, job.flattened.mean, job.flattened.stretch};
  summary.adjusted.distance = {proved.hausdorff, proved.mean, proved.stretch};
  summary.adjusted.stop = job.adjustment.stop;
  summary.adjusted.steps = job.adjustment.steps;
  summary.adjusted.best = job.adjustment.best;
  summary.adjusted.seam_mismatch = job.redrawn.seam_mismatch;
  summary.adjusted.settled = job.verified.drape.settled;
  summary.adjusted.residual = job.verified.drape.residual;
  summary.adjusted.max_penetration = job.verified.drape.max_penetration;
  summary.adjusted.girth = job.tailoring.girth;
  summary.adjusted.seam_length = job.tailoring.seam_length;
  summary.adjusted.level = job.tailoring.level;
  summary.adjusted.seconds = job.adjustment.seconds;
  summary.outlines = {job.redrawn.max_deviation, job.redrawn.symmetry};
  return summary;
}

RunReport report_of_drape(const Job& job, const ShownPictures& pictures, const std::vector<std::string>& files) {
  RunReport report;
  report.title = job.recipe.name;
  for (const Finding& finding : job.findings) report.outcome = std::max(report.outcome, finding.severity);
  report.inputs = inputs(job);
  report.drape_heading = "How it hangs";
  report.drape = drape_facts(job);
  report.height = job.scene.body.form.height;
  report.girths = girths(job);
  report.findings = job.findings;
  if (!job.stuck.png.empty())
    report.pictures = {
        {"Where dressing got stuck, in red: the panels before their seams were closed. To turn round: stuck.obj.",
         job.stuck.png}};
  for (const ReportPicture& picture : embedded(pictures.views)) report.pictures.push_back(picture);
  report.maps = embedded(pictures.maps);
  report.files = files;
  return report;
}

RunReport report_of(const Job& job, const std::string& recipe_text, const ShownPictures& pictures,
                    const std::vector<std::string>& files) {
  const AdjustStep& proved = job.verified.step;
  RunReport report = report_of_drape(job, pictures, files);
  report.verdict = verdict(job);
  report.certificate = certificate(job);
  report.drape_heading = "First drape";
  for (const ReportFact& fact : tailoring_facts(job.tailoring)) report.drape.push_back(fact);
  report.distances = {{"plain flattening", job.flattened.mean, job.flattened.hausdorff, job.flattened.stretch},
                      {"adjusted, read back and draped anew", proved.mean, proved.hausdorff, proved.stretch}};
  report.steps = job.adjustment.steps;
  report.best = job.adjustment.best;
  report.stop = in_words(job.adjustment.stop);
  report.seams = seams(job);
  report.edges = edges(job);
  report.recipe = recipe_text;
  return report;
}

}  // namespace toile
