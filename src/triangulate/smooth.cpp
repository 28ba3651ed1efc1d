#include "triangulate/smooth.h"

#include <algorithm>
#include <cmath>

#include "garment/units.h"
#include "triangulate/constrained_delaunay.h"

namespace toile {
namespace {

double twice_area(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

using Triangles = std::vector<std::array<int, 3>>;

// Sorted, each with its smallest vertex first.
Triangles delaunay(const std::vector<Eigen::Vector2d>& points, const std::vector<int>& near, std::size_t corners) {
  ConstrainedDelaunay mesh({points.begin(), points.begin() + static_cast<std::ptrdiff_t>(corners)});
  for (std::size_t i = corners; i < points.size(); ++i) mesh.insert(points[i], near[i]);
  Triangles triangles;
  for (const DelaunayTriangle& triangle : mesh.triangles()) {
    std::array<int, 3> t = triangle.vertex;
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

void one_round(Filling& filling, std::size_t corners, double wanted_angle) {
  std::vector<std::vector<int>> around(filling.points.size());
  for (std::size_t t = 0; t < filling.triangles.size(); ++t)
    for (const int v : filling.triangles[t]) around[static_cast<std::size_t>(v)].push_back(static_cast<int>(t));
  for (std::size_t v = corners; v < filling.points.size(); ++v) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double weight = 0;
    const auto worst = [&](const Eigen::Vector2d& place) {
      double least = 180;
      for (const int t : around[v]) {
        std::array<Eigen::Vector2d, 3> p;
        for (std::size_t c = 0; c < 3; ++c) {
          const int u = filling.triangles[static_cast<std::size_t>(t)][c];
          p[c] = u == static_cast<int>(v) ? place : filling.points[static_cast<std::size_t>(u)];
        }
        least = std::min(least, smallest_angle(p[0], p[1], p[2]));
      }
      return least;
    };
    for (const int t : around[v]) {
      const auto [a, b, c] = filling.triangles[static_cast<std::size_t>(t)];
      const Eigen::Vector2d& pa = filling.points[static_cast<std::size_t>(a)];
      const Eigen::Vector2d& pb = filling.points[static_cast<std::size_t>(b)];
      const Eigen::Vector2d& pc = filling.points[static_cast<std::size_t>(c)];
      const double area = twice_area(pa, pb, pc);
      sum += area * (pa + pb + pc) / 3;
      weight += area;
    }
    if (weight <= 0) continue;
    const Eigen::Vector2d place = sum / weight;
    const double after = worst(place);
    if (after >= wanted_angle || after >= worst(filling.points[v])) filling.points[v] = place;
  }
}

}  // namespace

double smallest_angle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const double area = twice_area(a, b, c);
  const double least = std::min(
      {std::atan2(area, (b - a).dot(c - a)), std::atan2(area, (c - b).dot(a - b)), std::atan2(area, (a - c).dot(b - c))});
  return least / degree;
}

Filling smooth(std::vector<Eigen::Vector2d> points, const std::vector<int>& near, int corners, int rounds,
               double wanted_angle) {
  const auto fixed = static_cast<std::size_t>(corners);
  Filling filling{std::move(points), {}};
  filling.triangles = delaunay(filling.points, near, fixed);
  for (int round = 0; round < rounds; ++round) {
    one_round(filling, fixed, wanted_angle);
    filling.triangles = delaunay(filling.points, near, fixed);
  }
  return filling;
}

}  // namespace toile
