#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "formats/dxf/drawing.h"
#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/drawn_piece.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/layers.h"
#include "formats/dxf_aama/nest.h"
#include "formats/dxf_aama/piece.h"
#include "formats/dxf_aama/units.h"
#include "formats/formats.h"

namespace toile {
namespace {

using aama::DrawnPiece;
using aama::LeftOut;
using aama::PieceBlock;

Eigen::AlignedBox2d box_of(const std::vector<aama::Run>& runs) {
  Eigen::AlignedBox2d box;
  for (const aama::Run& run : runs)
    for (const Eigen::Vector2d& p : run.points) box.extend(p);
  return box;
}

// What the sizes of the pieces, sorted in file units, say about the unit.
aama::UnitEvidence evidence_of(const std::vector<DrawnPiece>& pieces) {
  aama::UnitEvidence evidence;
  for (const DrawnPiece& piece : pieces) {
    Eigen::AlignedBox2d all, cut = box_of(piece.cut), sew = box_of(piece.sew);
    for (const auto* runs : {&piece.cut, &piece.sew, &piece.dense_cut, &piece.dense_sew}) all.extend(box_of(*runs));
    if (!all.isEmpty()) evidence.largest = std::max(evidence.largest, all.sizes().maxCoeff());
    for (const aama::DrawnNotch& notch : piece.notches)
      if (notch.depth > 0) evidence.notch_depths.push_back(notch.depth);
    if (cut.isEmpty() || sew.isEmpty()) continue;
    for (const double gap : {sew.min().x() - cut.min().x(), sew.min().y() - cut.min().y(), cut.max().x() - sew.max().x(),
                             cut.max().y() - sew.max().y()})
      if (gap > 1e-6 * all.sizes().maxCoeff()) evidence.allowances.push_back(gap);
  }
  return evidence;
}

std::vector<DrawnPiece> sorted(const std::vector<PieceBlock>& blocks, const dxf::Drawing& drawing, double unit,
                               const std::string& name, LeftOut& unknown_layers, LeftOut& unread) {
  std::vector<DrawnPiece> pieces;
  for (const PieceBlock& block : blocks) {
    pieces.push_back(
        aama::sort_by_layer(*block.block, aama::transform_of(*block.block, drawing.entities, unit), unknown_layers, unread));
    pieces.back().name = block.name;
    pieces.back().file = name;
  }
  return pieces;
}

void report_left_out(const LeftOut& unknown_layers, const LeftOut& unread, const std::string& name, Report& report) {
  const auto times = [](int count) { return std::to_string(count) + (count == 1 ? " time" : " times"); };
  for (const auto& [layer, count] : unknown_layers)
    report.warn("aama.unknown-layer", name,
                "layer '" + layer + "' is in no standard; its lines (" + std::to_string(count) + ") are kept as internal lines",
                "");
  for (const auto& [what, count] : unread)
    report.warn("aama.unsupported-entity", name, what + " (" + times(count) + ") is not read",
                "export the curves as polylines (R12)");
}

}  // namespace

Loaded<Pattern> read_dxf_aama_bytes(std::string_view bytes, const std::string& name, std::optional<double> unit_in_metres) {
  if (unit_in_metres && !(std::isfinite(*unit_in_metres) && *unit_in_metres > 0))
    throw std::invalid_argument("read_dxf_aama: the unit must be a positive number of metres");
  Loaded<dxf::Drawing> drawing = dxf::read_drawing(bytes, name);
  Loaded<Pattern> loaded{std::nullopt, std::move(drawing.report)};
  Report& report = loaded.report;
  if (!drawing.value) return loaded;

  const aama::StyleTexts style = aama::style_texts(drawing.value->entities);
  const std::vector<PieceBlock> blocks = aama::sample_size_blocks(*drawing.value, style, name, report);
  if (!report.ok()) return loaded;

  LeftOut unknown_layers, unread, counted_before, counted_before_too;
  aama::UnitEvidence evidence = evidence_of(sorted(blocks, *drawing.value, 1, name, counted_before, counted_before_too));
  evidence.style = style;
  evidence.header = drawing.value->header;
  const std::optional<double> unit = aama::decide_unit(evidence, unit_in_metres, name, report);
  if (!unit) return loaded;

  Pattern pattern;
  pattern.name = style.style.empty() ? name.substr(0, name.find_last_of('.')) : style.style;
  pattern.style = style.style;
  pattern.sample_size = style.sample_size.empty() ? blocks.front().texts.size : style.sample_size;
  for (DrawnPiece& drawn : sorted(blocks, *drawing.value, *unit, name, unknown_layers, unread))
    if (std::optional<Piece> piece = aama::make_piece(std::move(drawn), report)) pattern.pieces.push_back(std::move(*piece));
  report_left_out(unknown_layers, unread, name, report);
  if (report.ok()) loaded.value = std::move(pattern);
  return loaded;
}

Loaded<Pattern> read_dxf_aama(const std::filesystem::path& file, std::optional<double> unit_in_metres) {
  Loaded<std::string> bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, std::move(bytes.report)};
  Loaded<Pattern> loaded = read_dxf_aama_bytes(*bytes.value, file.filename().string(), unit_in_metres);
  Report report = std::move(bytes.report);
  report.append(loaded.report);
  return {std::move(loaded.value), std::move(report)};
}

}  // namespace toile
