#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "formats/inspection/inspection.h"
#include "garment/units.h"

namespace toile {
namespace {

PieceRow row_of(const Piece& piece, const std::string& size, const PieceFacts* facts) {
  PieceRow row;
  row.name = piece.name;
  row.size = size;
  row.as_drawn = piece.quantity;
  row.mirrored = piece.mirrored_quantity;
  row.material = piece.material;
  Eigen::AlignedBox2d box;
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) {
      box.extend(edge.points[i].at);
      ++row.outline_points;
      ++(edge.points[i].turn ? row.turn_points : row.curve_points);
    }
  if (!box.isEmpty()) {
    row.width_mm = box.sizes().x() * mm_per_m;
    row.height_mm = box.sizes().y() * mm_per_m;
    row.area_mm2 = signed_area(piece) * mm_per_m * mm_per_m;
  }
  row.notches = static_cast<int>(piece.notches.size());
  row.drill_holes = static_cast<int>(piece.drill_holes.size());
  row.internal_lines = static_cast<int>(piece.internal_lines.size());
  if (piece.grainline) {
    const Eigen::Vector2d along = piece.grainline->to - piece.grainline->from;
    const double angle = std::fmod(std::atan2(along.y(), along.x()) / degree + 360, 180.0);
    row.grainline_deg = angle > 180 - 1e-6 ? 0.0 : angle;
  }
  if (facts) {
    row.has_sew_line = facts->has_sew_line;
    row.sew_line_source = facts->sew_line_source;
    row.unfolded = facts->unfolded;
    row.graded_points = facts->graded_points;
  }
  return row;
}

const PieceFacts* facts_of(const PatternFile& file, const std::string& piece) {
  const auto found = std::find_if(file.facts.begin(), file.facts.end(), [&](const PieceFacts& f) { return f.piece == piece; });
  return found == file.facts.end() ? nullptr : &*found;
}

}  // namespace

std::vector<PieceRow> piece_rows(const PatternFile& file, bool only_chosen) {
  std::vector<PieceRow> rows;
  for (std::size_t i = 0; i < file.pattern.pieces.size(); ++i) {
    const PieceFacts* facts = facts_of(file, file.pattern.pieces[i].name);
    if (file.graded.empty() || only_chosen) {
      rows.push_back(row_of(file.pattern.pieces[i], file.pattern.sample_size, facts));
      continue;
    }
    for (std::size_t s = 0; s < file.graded.size(); ++s) rows.push_back(row_of(file.graded[s].pieces[i], file.sizes[s], facts));
  }
  return rows;
}

}  // namespace toile
