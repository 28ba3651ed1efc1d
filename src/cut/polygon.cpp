#include "cut/polygon.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

constexpr double touching = 1e-9;  // m

struct Box {
  Eigen::Vector2d low, high;
};

Box box_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

bool apart(const Box& a, const Box& b) {
  return ((a.low - b.high).array() > touching).any() || ((b.low - a.high).array() > touching).any();
}

std::vector<Box> segment_boxes(const Polygon& polygon) {
  std::vector<Box> boxes;
  for (std::size_t i = 0; i < polygon.size(); ++i) boxes.push_back(box_of(polygon[i], polygon[(i + 1) % polygon.size()]));
  return boxes;
}

bool folds_back(const Eigen::Vector2d& before, const Eigen::Vector2d& at, const Eigen::Vector2d& after) {
  const Eigen::Vector2d in = at - before;
  const Eigen::Vector2d out = after - at;
  return in.dot(out) <= 0 && std::abs(cross(in, out)) <= touching * std::max(in.norm(), out.norm());
}

}  // namespace

double signed_area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

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

std::optional<std::pair<int, int>> first_self_crossing(const Polygon& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return std::pair{0, 0};
  const std::vector<Box> boxes = segment_boxes(polygon);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (folds_back(polygon[i], polygon[next], polygon[(i + 2) % n]))
      return std::pair{static_cast<int>(i), static_cast<int>(next)};
    for (std::size_t j = i + 2; j < n; ++j) {
      if ((j + 1) % n == i || apart(boxes[i], boxes[j])) continue;
      if (distance(polygon[i], polygon[next], polygon[j], polygon[(j + 1) % n]) <= touching)
        return std::pair{static_cast<int>(i), static_cast<int>(j)};
    }
  }
  return std::nullopt;
}

bool overlap(const Polygon& a, const Polygon& b) {
  if (a.empty() || b.empty()) return false;
  const std::vector<Box> boxes_a = segment_boxes(a);
  const std::vector<Box> boxes_b = segment_boxes(b);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (apart(boxes_a[i], boxes_b[j])) continue;
      if (distance(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]) <= touching) return true;
    }
  return contains(a, b.front()) || contains(b, a.front());
}

}  // namespace toile
