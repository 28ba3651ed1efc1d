#include <algorithm>
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

}  // namespace

std::vector<Eigen::Vector2d> flattened(const Entity& polyline, double chord) {
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
