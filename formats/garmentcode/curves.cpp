#include "formats/garmentcode/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {

std::vector<Eigen::Vector2d> bezier_between(const std::vector<Eigen::Vector2d>& control, double tolerance) {
  // A chord over a parameter step h departs by at most h^2/8 times the largest second derivative, which a control polygon
  // bounds.
  const double degree = static_cast<double>(control.size() - 1);
  double second = 0;
  for (std::size_t i = 2; i < control.size(); ++i)
    second = std::max(second, degree * (degree - 1) * (control[i] - 2 * control[i - 1] + control[i - 2]).norm());
  const int steps = std::max(2, static_cast<int>(std::ceil(std::sqrt(second / (8 * tolerance)))));
  std::vector<Eigen::Vector2d> points;
  for (int k = 1; k < steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    std::vector<Eigen::Vector2d> row = control;  // de Casteljau
    while (row.size() > 1) {
      for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] = (1 - t) * row[i] + t * row[i + 1];
      row.pop_back();
    }
    points.push_back(row[0]);
  }
  return points;
}

std::vector<Eigen::Vector2d> arc_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius, bool large,
                                         bool right, double tolerance) {
  const Eigen::Vector2d chord = to - from;
  const double half = chord.norm() / 2;
  const double r = std::max(radius, half);
  const Eigen::Vector2d left(-chord.y(), chord.x());
  // Bulging to the right is running counter-clockwise about a centre that lies to the left, unless it is the long way round.
  const double side = (right != large ? 1 : -1) * std::sqrt(std::max(r * r - half * half, 0.0)) / (2 * half);
  const Eigen::Vector2d centre = (from + to) / 2 + side * left;
  const double short_way = 2 * std::asin(std::min(half / r, 1.0));
  const double sweep = (right ? 1 : -1) * (large ? 2 * std::numbers::pi - short_way : short_way);
  const double step = 4 * std::asin(std::min(std::sqrt(tolerance / (2 * r)), 1.0));  // its chord's sagitta is the tolerance
  const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(sweep) / step)));
  const double begin = std::atan2(from.y() - centre.y(), from.x() - centre.x());
  std::vector<Eigen::Vector2d> points;
  for (int k = 1; k < steps; ++k) {
    const double angle = begin + sweep * k / steps;
    points.push_back(centre + r * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

}  // namespace toile
