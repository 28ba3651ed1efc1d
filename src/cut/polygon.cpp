#include "cut/polygon.h"

#include <algorithm>
#include <cmath>

namespace toile {
namespace {

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
