#include "geometry/plane_segments.h"

#include <algorithm>
#include <cmath>

namespace toile {

std::optional<std::pair<double, double>> crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                                                  const Eigen::Vector2d& d) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d cd = d - c;
  const double area = cross(ab, cd);
  if (std::abs(area) <= 1e-14 * ab.norm() * cd.norm() || area == 0) return std::nullopt;
  const double s = cross(c - a, cd) / area;
  const double t = cross(c - a, ab) / area;
  const double slack = 1e-12;
  if (s < -slack || s > 1 + slack || t < -slack || t > 1 + slack) return std::nullopt;
  return std::pair{std::clamp(s, 0.0, 1.0), std::clamp(t, 0.0, 1.0)};
}

double distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double squared = ab.squaredNorm();
  const double t = squared > 0 ? std::clamp((point - a).dot(ab) / squared, 0.0, 1.0) : 0.0;
  return (a + t * ab - point).norm();
}

double distance(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d) {
  if (crossing(a, b, c, d)) return 0;
  return std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b), distance(d, a, b)});
}

}  // namespace toile
