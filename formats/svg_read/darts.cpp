#include "formats/svg_read/darts.h"

#include <cmath>

#include "garment/units.h"
#include "geometry/polyline.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

constexpr double shortest_leg = 15e-3, widest_mouth = .12;  // m
constexpr double uneven_legs = .15;                         // of the longer

double turn(const Vector2d& a, const Vector2d& b) { return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)); }

// Whether two edges, one after the other, are the legs of a dart: they go in to an apex and come out beside where they began.
bool are_legs(const Edge& in, const Edge& out) {
  const double a = length(in), b = length(out);
  if (std::min(a, b) < shortest_leg || std::abs(a - b) > uneven_legs * std::max(a, b)) return false;
  const Vector2d begin = in.points.front().at, apex = in.points.back().at, end = out.points.back().at;
  const double mouth = (end - begin).norm();
  if (mouth > widest_mouth || mouth > .8 * std::min(a, b) || mouth < 1e-3) return false;
  return turn(apex - begin, end - apex) < -100 * units::degree;
}

// An open V, or a closed line of four corners much longer than wide.
bool is_dart_inside(const InternalLine& line) {
  const std::size_t n = line.points.size();
  const bool closed = n > 3 && (line.points.back() - line.points.front()).norm() < 1e-4;
  if (n == 3 && !closed) {
    const double a = (line.points[1] - line.points[0]).norm(), b = (line.points[2] - line.points[1]).norm();
    return std::min(a, b) > shortest_leg && std::abs(a - b) < uneven_legs * std::max(a, b) &&
           (line.points[2] - line.points[0]).norm() < .8 * std::min(a, b) &&
           std::abs(turn(line.points[1] - line.points[0], line.points[2] - line.points[1])) < 179 * units::degree;
  }
  if (!closed || n != 5) return false;
  const double across = (line.points[2] - line.points[0]).norm(), other = (line.points[3] - line.points[1]).norm();
  const double side = (line.points[1] - line.points[0]).norm() - (line.points[3] - line.points[0]).norm();
  const double side2 = (line.points[2] - line.points[1]).norm() - (line.points[1] - line.points[0]).norm();
  const double longest = std::max(across, other);
  return longest > 2 * std::min(across, other) && longest > 2 * shortest_leg &&
         std::min(std::abs(side), std::abs(side2)) < .1 * longest;
}

}  // namespace

void name_darts(Piece& piece, const std::string& place, Report& report) {
  std::string named;
  int count = 0;
  const std::size_t n = piece.outline.size();
  for (std::size_t i = 0; i < n && n > 3; ++i) {
    Edge &in = piece.outline[i], &out = piece.outline[(i + 1) % n];
    if (in.id.compare(0, 4, "dart") == 0 || !are_legs(in, out)) continue;
    const std::string name = "dart" + std::to_string(++count);
    for (const auto& [edge, id] : {std::pair{&in, name + "a"}, std::pair{&out, name + "b"}}) {
      for (Notch& notch : piece.notches)
        if (notch.edge == edge->id) notch.edge = id;
      edge->id = id;
    }
    named += (named.empty() ? "" : ", ") + in.id + " and " + out.id + " (" + in_mm(length(in), 0) + " deep, " +
             in_mm((out.points.back().at - in.points.front().at).norm(), 0) + " wide)";
  }
  int inside = 0;
  for (const InternalLine& line : piece.internal_lines) inside += is_dart_inside(line);
  if (count > 0)
    report.note("svg.darts", place,
                std::to_string(count) + (count == 1 ? " dart" : " darts") + " or slits in the outline: " + named);
  if (inside > 0)
    report.note("svg.darts", place,
                std::to_string(inside) + " internal line" + (inside == 1 ? " is" : "s are") +
                    " drawn as a dart; kept as internal lines, not sewn");
}

}  // namespace toile::svg
