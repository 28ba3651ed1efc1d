#include <algorithm>
#include <array>
#include <cmath>

#include "formats/dxf/drawing.h"

namespace toile::dxf {
namespace {

// Appends the inner points of the arc from `a` to `b`. With bulge k the arc turns by 4 atan(k), counter-clockwise when
// positive.
void append_arc(std::vector<Eigen::Vector2d>& points, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bulge,
                double chord) {
  const double angle = 4 * std::atan(bulge);
  const double width = (b - a).norm();
  if (width == 0 || !std::isfinite(angle)) return;
  const double radius = width / (2 * std::abs(std::sin(angle / 2)));
  // A chord over the angle s leaves the arc by r (1 - cos(s / 2)).
  const double step = 2 * std::acos(std::clamp(1 - chord / radius, -1.0, 1.0));
  const double wanted = step > 0 ? std::ceil(std::abs(angle) / step) : 1000.0;
  const int count = static_cast<int>(std::clamp(wanted, 1.0, 1000.0));
  const Eigen::Vector2d across(-(b - a).y(), (b - a).x());
  const Eigen::Vector2d centre = (a + b) / 2 + across / (2 * std::tan(angle / 2));
  for (int i = 1; i < count; ++i) {
    const double turn = angle * i / count;
    const Eigen::Vector2d d = a - centre;
    points.emplace_back(centre.x() + std::cos(turn) * d.x() - std::sin(turn) * d.y(),
                        centre.y() + std::sin(turn) * d.x() + std::cos(turn) * d.y());
  }
}

// The point of a spline at `u` in the knot span [knots[span], knots[span + 1]] (de Boor, homogeneous coordinates).
Eigen::Vector2d on_spline(const Entity& spline, std::size_t span, double u) {
  const auto degree = static_cast<std::size_t>(spline.degree);
  std::array<Eigen::Vector3d, 16> d;
  for (std::size_t i = 0; i <= degree; ++i) {
    const std::size_t at = span - degree + i;
    const double weight = spline.weights.empty() ? 1.0 : spline.weights[at];
    d[i] << weight * spline.points[at], weight;
  }
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t i = degree; i >= r; --i) {
      const double low = spline.knots[span - degree + i], high = spline.knots[span + 1 + i - r];
      const double t = high > low ? (u - low) / (high - low) : 0;
      d[i] = (1 - t) * d[i - 1] + t * d[i];
    }
  return d[degree].head<2>() / d[degree].z();
}

double off_chord(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double t = ab.squaredNorm() > 0 ? std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) : 0;
  return (p - a - t * ab).norm();
}

struct Flattener {
  const Entity& spline;
  double chord;
  std::vector<Eigen::Vector2d>& points;

  // Appends what lies between u0 and u1 and the end.
  void part(std::size_t span, double u0, const Eigen::Vector2d& a, double u1, const Eigen::Vector2d& b, int depth) const {
    constexpr int deepest = 10;
    bool straight = depth > 0;
    for (const double t : {.25, .5, .75})
      straight = straight && off_chord(on_spline(spline, span, u0 + t * (u1 - u0)), a, b) <= chord;
    if (straight || depth == deepest) {
      points.push_back(b);
      return;
    }
    const double middle = (u0 + u1) / 2;
    const Eigen::Vector2d m = on_spline(spline, span, middle);
    part(span, u0, a, middle, m, depth + 1);
    part(span, middle, m, u1, b, depth + 1);
  }
};

std::vector<Eigen::Vector2d> flattened_spline(const Entity& spline, double chord) {
  std::vector<Eigen::Vector2d> points;
  const auto degree = static_cast<std::size_t>(spline.degree);
  const Flattener flattener{spline, chord, points};
  for (std::size_t span = degree; span < spline.points.size(); ++span) {
    const double u0 = spline.knots[span], u1 = spline.knots[span + 1];
    if (!(u1 > u0)) continue;
    const Eigen::Vector2d a = on_spline(spline, span, u0);
    if (points.empty()) points.push_back(a);
    if (spline.degree == 1)
      points.push_back(on_spline(spline, span, u1));
    else
      flattener.part(span, u0, a, u1, on_spline(spline, span, u1), 0);
  }
  return points;
}

}  // namespace

std::vector<Eigen::Vector2d> flattened(const Entity& polyline, double chord) {
  if (polyline.degree > 0) return flattened_spline(polyline, chord);
  std::vector<Eigen::Vector2d> points;
  const std::size_t n = polyline.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    points.push_back(polyline.points[i]);
    const double bulge = i < polyline.bulges.size() ? polyline.bulges[i] : 0.0;
    const bool last = i + 1 == n;
    if (bulge != 0 && (!last || polyline.closed))
      append_arc(points, polyline.points[i], polyline.points[last ? 0 : i + 1], bulge, chord);
  }
  return points;
}

}  // namespace toile::dxf
