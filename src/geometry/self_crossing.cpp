#include "geometry/self_crossing.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "geometry/plane_segments.h"

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Eigen::Vector2d;

Kernel::Point_2 point(const Vector2d& p) { return {p.x(), p.y()}; }

bool folds_back(const Vector2d& a, const Vector2d& b, const Vector2d& c, double touching) {
  const Vector2d in = b - a, out = c - b;
  if (touching > 0) return in.dot(out) <= 0 && std::abs(cross(in, out)) <= touching * std::max(in.norm(), out.norm());
  return in.dot(out) < 0 && CGAL::orientation(point(a), point(b), point(c)) == CGAL::COLLINEAR;
}

bool meet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d, double touching) {
  return CGAL::do_intersect(Kernel::Segment_2(point(a), point(b)), Kernel::Segment_2(point(c), point(d))) ||
         (touching > 0 && distance(a, b, c, d) <= touching);
}

}  // namespace

std::optional<SelfCrossing> first_self_crossing(const std::vector<Vector2d>& loop, double touching) {
  const std::size_t n = loop.size();
  if (n < 3) return SelfCrossing{};
  const auto end = [&](std::size_t i) -> const Vector2d& { return loop[(i + 1) % n]; };
  const auto left = [&](std::size_t i) { return std::min(loop[i].x(), end(i).x()); };
  const auto right = [&](std::size_t i) { return std::max(loop[i].x(), end(i).x()); };
  std::vector<std::size_t> by_left(n);
  std::iota(by_left.begin(), by_left.end(), std::size_t{0});
  std::sort(by_left.begin(), by_left.end(),
            [&](std::size_t a, std::size_t b) { return std::pair(left(a), a) < std::pair(left(b), b); });
  std::optional<SelfCrossing> found;
  const auto report = [&](std::size_t a, std::size_t b) {
    const SelfCrossing crossing{static_cast<int>(std::min(a, b)), static_cast<int>(std::max(a, b))};
    if (!found || std::pair(crossing.first, crossing.second) < std::pair(found->first, found->second)) found = crossing;
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = by_left[i];
    for (std::size_t j = i + 1; j < n && left(by_left[j]) <= right(a) + touching; ++j) {
      const std::size_t b = by_left[j];
      if ((a + 1) % n == b || (b + 1) % n == a) continue;
      if (std::max(loop[a].y(), end(a).y()) + touching < std::min(loop[b].y(), end(b).y()) ||
          std::max(loop[b].y(), end(b).y()) + touching < std::min(loop[a].y(), end(a).y()))
        continue;
      if (meet(loop[a], end(a), loop[b], end(b), touching)) report(a, b);
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    if (folds_back(loop[i], end(i), end((i + 1) % n), touching)) report(i, (i + 1) % n);
  return found;
}

}  // namespace toile
