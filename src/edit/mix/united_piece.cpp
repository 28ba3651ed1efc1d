#include "edit/mix/united_piece.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "edit/mix/marks.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr int samples = 64;  // of an edge

// The motion that takes `from` nearest to `onto`, point by point; a reflection first when asked for.
Isometry laid_against(const std::vector<Eigen::Vector2d>& from, const std::vector<Eigen::Vector2d>& onto, bool reflected) {
  const Eigen::Matrix2d flip = Eigen::Vector2d(reflected ? -1 : 1, 1).asDiagonal();
  const auto count = static_cast<double>(from.size());
  Eigen::Vector2d middle = Eigen::Vector2d::Zero(), goal = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) {
    middle += flip * from[i] / count;
    goal += onto[i] / count;
  }
  double dot = 0, cross = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Eigen::Vector2d a = flip * from[i] - middle, b = onto[i] - goal;
    dot += a.dot(b);
    cross += a.x() * b.y() - a.y() * b.x();
  }
  const double angle = std::atan2(cross, dot);
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  return {turn * flip, goal - turn * middle};
}

// Moves one end of an edge, and the rest of it the less the farther away.
void draw_end(Edge& edge, bool front, const Eigen::Vector2d& to) {
  const Eigen::Vector2d by = to - (front ? edge.points.front() : edge.points.back()).at;
  const double size = length(edge);
  double along = 0;
  std::vector<double> at{0};
  for (std::size_t i = 1; i < edge.points.size(); ++i) {
    along += (edge.points[i].at - edge.points[i - 1].at).norm();
    at.push_back(size > 0 ? along / size : 1);
  }
  for (std::size_t i = 0; i < edge.points.size(); ++i) edge.points[i].at += (front ? 1 - at[i] : at[i]) * by;
  (front ? edge.points.front() : edge.points.back()).at = to;
}

Edge laid(Edge edge, const Isometry& lay, bool reversed) {
  for (OutlinePoint& point : edge.points) point.at = lay(point.at);
  if (reversed) std::reverse(edge.points.begin(), edge.points.end());
  return edge;
}

std::string free_id(const std::vector<Edge>& outline, const std::string& id) {
  std::string name = id;
  const auto taken = [&] { return std::any_of(outline.begin(), outline.end(), [&](const Edge& e) { return e.id == name; }); };
  for (int i = 2; taken(); ++i) name = id + "_" + std::to_string(i);
  return name;
}

void take_marks(const Piece& base, const Piece& other, UnitedPiece& united) {
  Piece& piece = united.piece;
  piece.notches.clear();
  for (std::size_t e = 0; e < united.origin.size(); ++e) {
    const EdgeOrigin& origin = united.origin[e];
    const Piece& from = origin.of_base ? base : other;
    for (Notch notch : from.notches) {
      if (notch.edge != from.outline[static_cast<std::size_t>(origin.edge)].id) continue;
      notch.edge = piece.outline[e].id;
      if (origin.reversed) notch.at = 1 - notch.at;
      piece.notches.push_back(notch);
    }
  }
  piece.internal_lines = base.internal_lines;
  for (InternalLine line : other.internal_lines) {
    for (Eigen::Vector2d& point : line.points) point = united.lay(point);
    piece.internal_lines.push_back(std::move(line));
  }
  piece.drill_holes = base.drill_holes;
  for (DrillHole hole : other.drill_holes) {
    hole.at = united.lay(hole.at);
    piece.drill_holes.push_back(hole);
  }
  for (const std::string& note : other.annotations)
    if (std::find(piece.annotations.begin(), piece.annotations.end(), note) == piece.annotations.end())
      piece.annotations.push_back(note);
  piece.grainline = base.grainline;
  if (!other.grainline) return;
  const Grainline grain{united.lay(other.grainline->from), united.lay(other.grainline->to)};
  if (!piece.grainline) {
    piece.grainline = grain;
    return;
  }
  const Eigen::Vector2d a = (base.grainline->to - base.grainline->from).normalized(), b = (grain.to - grain.from).normalized();
  united.grain_turn = std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), std::abs(a.dot(b)));
}

}  // namespace

UnitedPiece united_piece(const Pattern& pattern, const PieceJoin& join) {
  const Piece& base = pattern.pieces[static_cast<std::size_t>(join.base)];
  const Piece& other = pattern.pieces[static_cast<std::size_t>(join.other)];
  const auto base_edge = static_cast<std::size_t>(join.base_edge), other_edge = static_cast<std::size_t>(join.other_edge);
  const auto onto = resample<2>(positions(base.outline[base_edge]), samples);
  auto from = resample<2>(positions(other.outline[other_edge]), samples);
  if (!join.reflected) std::reverse(from.begin(), from.end());
  UnitedPiece united;
  united.lay = laid_against(from, onto, join.reflected);
  for (std::size_t i = 0; i < from.size(); ++i)
    united.edges_apart = std::max(united.edges_apart, (united.lay(from[i]) - onto[i]).norm());

  std::vector<Edge> outline;
  const auto add = [&](Edge edge, const EdgeOrigin& origin) {
    edge.id = free_id(outline, edge.id);
    outline.push_back(std::move(edge));
    united.origin.push_back(origin);
  };
  const auto bases = base.outline.size(), others = other.outline.size();
  for (std::size_t e = 0; e < base_edge; ++e) add(base.outline[e], {true, static_cast<int>(e), false});
  for (std::size_t k = 1; k < others; ++k) {
    const std::size_t e = join.reflected ? (other_edge + others - k) % others : (other_edge + k) % others;
    add(laid(other.outline[e], united.lay, join.reflected), {false, static_cast<int>(e), join.reflected});
  }
  for (std::size_t e = base_edge + 1; e < bases; ++e) add(base.outline[e], {true, static_cast<int>(e), false});
  const std::size_t count = outline.size(), first = base_edge, last = base_edge + others - 2;  // the other piece's edges
  const std::size_t before = (first + count - 1) % count, after = (last + 1) % count;
  const Eigen::Vector2d start = (onto.front() + united.lay(from.front())) / 2,
                        end = (onto.back() + united.lay(from.back())) / 2;
  draw_end(outline[before], false, start);
  draw_end(outline[first], true, start);
  draw_end(outline[last], false, end);
  draw_end(outline[after], true, end);

  std::vector<int> copies;
  for (const auto& [of_base, of_other] : join.copies) copies.push_back(of_base);
  united.piece = marked_like(base, std::move(outline), copies);
  if (base.name.rfind(other.name + "_", 0) == 0) united.piece.name = other.name;  // which had it first
  take_marks(base, other, united);
  return united;
}

}  // namespace toile
