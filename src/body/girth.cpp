#include "body/girth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace toile {
namespace {

using Edge2 = std::pair<int, int>;
using Loop2 = std::vector<Eigen::Vector2d>;

struct PlaneAxes {
  Eigen::Vector3d first, second;
};

PlaneAxes axes_of(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d n = normal.normalized();
  const Eigen::Vector3d aside = std::abs(n.x()) < .8 ? Eigen::Vector3d::UnitX() : Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d second = n.cross(aside).normalized();
  return {second.cross(n), second};
}

Loop2 flattened(const SectionLoop& loop, const PlaneAxes& axes) {
  Loop2 flat;
  for (const Eigen::Vector3d& p : loop) flat.emplace_back(p.dot(axes.first), p.dot(axes.second));
  return flat;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double area(const Loop2& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += cross(loop[i], loop[(i + 1) % loop.size()]);
  return sum / 2;
}

double perimeter(const Loop2& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) sum += (loop[(i + 1) % loop.size()] - loop[i]).norm();
  return sum;
}

// Andrew's monotone chain.
Loop2 hull(Loop2 points) {
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
  Loop2 chain;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t start = chain.size();
    for (const Eigen::Vector2d& p : points) {
      while (chain.size() >= start + 2 && cross(chain.back() - chain[chain.size() - 2], p - chain.back()) <= 0)
        chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

// Distance of `at` from the loop, negative when it is enclosed.
double signed_distance(const Loop2& loop, const Eigen::Vector2d& at) {
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector2d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const Eigen::Vector2d along = b - a;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((at - a).dot(along) / squared, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (at - a - t * along).norm());
    if ((a.y() > at.y()) != (b.y() > at.y()) && at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * along.x())
      inside = !inside;
  }
  return inside ? -nearest : nearest;
}

// The part of the loop with side * x >= 0, closed along the midplane.
SectionLoop on_side(const SectionLoop& loop, double side) {
  SectionLoop kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if (side * a.x() >= 0) kept.push_back(a);
    if ((a.x() > 0) != (b.x() > 0) && a.x() != b.x()) kept.push_back(a + a.x() / (a.x() - b.x()) * (b - a));
  }
  return kept;
}

bool crosses_midplane(const SectionLoop& loop) {
  const auto [least, most] =
      std::minmax_element(loop.begin(), loop.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
  return least->x() < 0 && most->x() > 0;
}

}  // namespace

std::vector<SectionLoop> section_loops(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                                       const Eigen::Vector3d& at, const Eigen::Vector3d& normal) {
  const Eigen::VectorXd height = (positions.colwise() - at).transpose() * normal.normalized();
  const auto above = [&](int v) { return height(v) >= 0; };  // a vertex in the plane counts as above, so no curve is cut twice
  struct Step {
    Edge2 next;
    Eigen::Vector3d point;
  };
  std::map<Edge2, Step> steps;
  std::vector<Edge2> order;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    Edge2 enter{-1, -1}, leave{-1, -1};
    for (int k = 0; k < 3; ++k) {
      const int a = triangles(k, t), b = triangles((k + 1) % 3, t);
      if (above(a) == above(b)) continue;
      (above(a) ? enter : leave) = std::minmax(a, b);
    }
    if (enter.first < 0) continue;
    // Walks with the inside on its left, seen against the normal.
    const double from = height(enter.first), to = height(enter.second);
    const Eigen::Vector3d point =
        positions.col(enter.first) + from / (from - to) * (positions.col(enter.second) - positions.col(enter.first));
    if (steps.emplace(enter, Step{leave, point}).second) order.push_back(enter);
  }
  std::vector<SectionLoop> loops;
  for (const Edge2& first : order) {
    SectionLoop loop;
    auto step = steps.find(first);
    while (step != steps.end()) {
      loop.push_back(step->second.point);
      const Edge2 next = step->second.next;
      steps.erase(step);
      if (next == first) {
        if (loop.size() >= 3) loops.push_back(std::move(loop));
        break;
      }
      step = steps.find(next);
    }
  }
  return loops;
}

double loop_girth(const SectionLoop& loop, const Eigen::Vector3d& normal, GirthKind kind) {
  if (loop.size() < 3) return 0;
  const Loop2 flat = flattened(loop, axes_of(normal));
  return perimeter(kind == GirthKind::tape ? hull(flat) : flat);
}

double trunk_girth(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, double height_y, GirthKind kind) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  const PlaneAxes axes = axes_of(up);
  double largest = 0, girth = 0;
  for (const SectionLoop& loop : section_loops(positions, triangles, height_y * up, up)) {
    if (!crosses_midplane(loop)) continue;
    const double enclosed = std::abs(area(flattened(loop, axes)));
    if (enclosed <= largest) continue;
    largest = enclosed;
    girth = loop_girth(loop, up, kind);
  }
  return girth;
}

double limb_girth(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& along, GirthKind kind) {
  const PlaneAxes axes = axes_of(along);
  const Eigen::Vector2d centre(at.dot(axes.first), at.dot(axes.second));
  double nearest = std::numeric_limits<double>::infinity(), girth = 0;
  for (SectionLoop& loop : section_loops(positions, triangles, at, along)) {
    const double away = signed_distance(flattened(loop, axes), centre);
    if (away >= nearest) continue;
    nearest = away;
    if (at.x() != 0 && crosses_midplane(loop)) loop = on_side(loop, at.x() > 0 ? 1 : -1);
    girth = loop_girth(loop, along, kind);
  }
  return girth;
}

}  // namespace toile
