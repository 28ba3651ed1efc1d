#include "formats/dxf_aama/turn_points.h"

#include <algorithm>
#include <cmath>

#include "garment/units.h"

namespace toile::aama {
namespace {

constexpr double corner_angle = 20 * units::degree;
constexpr double most_curve_turn = 40 * units::degree;  // between two chords of one sampled curve
constexpr double one_corner = 0.5e-3;                   // m

double turn_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

// The angle between the chord `near` and the tangent, at its outer end, of the circle through it and the next chord `far`, when
// the line turns by `turn` between them. A sharp turn is no circle's.
double bend(double turn, const Eigen::Vector2d& near, const Eigen::Vector2d& far) {
  return std::abs(turn) > most_curve_turn ? 0.0 : turn * near.norm() / (near.norm() + far.norm());
}

}  // namespace

std::vector<bool> corners_by_angle(const Points<2>& ring, double angle) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (kept.empty() || (ring[i] - ring[kept.back()]).norm() > one_corner) kept.push_back(i);
  while (kept.size() > 3 && (ring[kept.back()] - ring[kept.front()]).norm() <= one_corner) kept.pop_back();

  std::vector<bool> corner(ring.size(), false);
  const std::size_t n = kept.size();
  if (n < 3) return corner;
  const auto chord = [&](std::size_t i) -> Eigen::Vector2d { return ring[kept[(i + 1) % n]] - ring[kept[i % n]]; };
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector2d before2 = chord(i + n - 2), before = chord(i + n - 1), after = chord(i), after2 = chord(i + 1);
    const double sharp = turn_between(before, after) - bend(turn_between(before2, before), before, before2) -
                         bend(turn_between(after, after2), after, after2);
    corner[kept[i]] = std::abs(sharp) > angle;
  }
  return corner;
}

TurnPoints turn_points(const Points<2>& ring, const DrawnPiece& piece, const std::optional<Axis>& fold) {
  TurnPoints found;
  found.turn.assign(ring.size(), false);
  std::vector<bool> marked(ring.size(), false);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    double nearest = std::nextafter(piece.tolerance, 1.0);
    for (const MarkedPoint& point : piece.points) {
      const double off = (ring[i] - point.at).norm();
      if (off >= nearest) continue;
      nearest = off;
      marked[i] = true;
      found.turn[i] = point.turn;
    }
  }
  const auto marks = std::count(marked.begin(), marked.end(), true);
  const auto turns = std::count(found.turn.begin(), found.turn.end(), true);
  const std::vector<bool> corners = corners_by_angle(ring, corner_angle);
  found.by_angle = turns == 0 || marks < 2;
  if (found.by_angle) found.turn = corners;
  if (fold && !found.by_angle)
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (distance_to_axis(ring[i], *fold) <= same_vertex) found.turn[i] = corners[i];
  if (std::none_of(found.turn.begin(), found.turn.end(), [](bool turn) { return turn; })) found.turn.front() = true;
  return found;
}

}  // namespace toile::aama
