#include "triangulate/fill.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "triangulate/constrained_delaunay.h"
#include "triangulate/sizing.h"
#include "triangulate/smooth.h"

namespace toile {
namespace {

constexpr double good_radius = .72;       // circumradius over size: a right isosceles triangle has .71, an equilateral one .58
constexpr double nearest_vertex = .7;     // of the size: a new point keeps this far from others,
constexpr double nearest_outline = .62;   // and this far from the outline
constexpr double tolerable_radius = .85;  // larger triangles left by the front get a point at their circumcentre
constexpr int smoothing_rounds = 12;

// Points on a grid of cells, so that the neighbours of a place are found at once.
class PointGrid {
 public:
  explicit PointGrid(double cell) : cell_(cell) {}
  void add(const Eigen::Vector2d& p) { cells_[key(p)].push_back(p); }
  bool any_within(const Eigen::Vector2d& p, double distance) const {
    const auto [x, y] = key(p);
    const int reach = static_cast<int>(std::ceil(distance / cell_));
    for (int i = x - reach; i <= x + reach; ++i)
      for (int j = y - reach; j <= y + reach; ++j) {
        const auto found = cells_.find({i, j});
        if (found == cells_.end()) continue;
        for (const Eigen::Vector2d& q : found->second)
          if ((p - q).squaredNorm() < distance * distance) return true;
      }
    return false;
  }

 private:
  std::pair<int, int> key(const Eigen::Vector2d& p) const {
    return {static_cast<int>(std::floor(p.x() / cell_)), static_cast<int>(std::floor(p.y() / cell_))};
  }
  double cell_;
  std::map<std::pair<int, int>, std::vector<Eigen::Vector2d>> cells_;
};

struct Circle {
  Eigen::Vector2d centre;
  double radius;
};

Circle circumcircle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d u = b - a, v = c - a;
  const double twice_area = u.x() * v.y() - u.y() * v.x();
  const Eigen::Vector2d to_centre =
      Eigen::Vector2d(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(), u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
      (2 * twice_area);
  return {a + to_centre, to_centre.norm()};
}

// The point that makes a good triangle on the side a-b, on its left, within the empty circle `circle`. Rebay 1993, Eq. 1-3.
Eigen::Vector2d front_point(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Circle& circle, double size) {
  const Eigen::Vector2d middle = (a + b) / 2;
  const Eigen::Vector2d inward = Eigen::Vector2d(a.y() - b.y(), b.x() - a.x()).normalized();
  const double p = (b - a).norm() / 2;
  const double q = std::max(inward.dot(circle.centre - middle), 1e-9 * p);
  const double radius = std::min(std::max(size / std::numbers::sqrt3, p), (p * p + q * q) / (2 * q));
  return middle + inward * (radius + std::sqrt(std::max(radius * radius - p * p, 0.0)));
}

class Front {
 public:
  Front(const std::vector<Eigen::Vector2d>& loop, double edge_length)
      : sizing_(loop, edge_length), grid_(edge_length), mesh_(loop), points_(loop), near_(loop.size(), 0) {
    for (const Eigen::Vector2d& p : loop) grid_.add(p);
  }

  // Triangles on the outline first, then on those already good, until no triangle too large has a place for a point.
  void advance() {
    while (insert(wanted_by_front())) {
    }
    while (insert(wanted_at_circumcentres())) {
    }
  }

  const std::vector<Eigen::Vector2d>& points() const { return points_; }
  const std::vector<int>& near() const { return near_; }  // for each point one that came before it, not far away

 private:
  struct Wanted {
    double urgency;
    int triangle, near;
    Eigen::Vector2d place;
  };

  const Eigen::Vector2d& at(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }

  // Circumradius over the size wanted there.
  double largeness(const DelaunayTriangle& t, const Circle& circle) const {
    return circle.radius / sizing_.size((at(t.vertex[0]) + at(t.vertex[1]) + at(t.vertex[2])) / 3);
  }

  std::vector<Wanted> wanted_by_front() {
    const std::vector<DelaunayTriangle> triangles = mesh_.triangles();
    std::vector<Circle> circles;
    std::vector<double> large;
    for (const DelaunayTriangle& t : triangles) {
      circles.push_back(circumcircle(at(t.vertex[0]), at(t.vertex[1]), at(t.vertex[2])));
      large.push_back(largeness(t, circles.back()));
    }
    std::vector<Wanted> wanted;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (large[t] <= good_radius) continue;
      int base = -1;  // its shortest side on the front, by the corner opposite
      double shortest = std::numeric_limits<double>::infinity();
      for (int side = 0; side < 3; ++side) {
        const int beyond = triangles[t].neighbour[static_cast<std::size_t>(side)];
        if (beyond >= 0 && large[static_cast<std::size_t>(beyond)] > good_radius) continue;
        const double length = (at(triangles[t].vertex[static_cast<std::size_t>((side + 1) % 3)]) -
                               at(triangles[t].vertex[static_cast<std::size_t>((side + 2) % 3)]))
                                  .norm();
        if (length < shortest) {
          base = side;
          shortest = length;
        }
      }
      if (base < 0) continue;
      const int a = triangles[t].vertex[static_cast<std::size_t>((base + 1) % 3)];
      const int b = triangles[t].vertex[static_cast<std::size_t>((base + 2) % 3)];
      const double size = sizing_.size((at(a) + at(b)) / 2);
      wanted.push_back({large[t], static_cast<int>(t), a, front_point(at(a), at(b), circles[t], size)});
    }
    return wanted;
  }

  std::vector<Wanted> wanted_at_circumcentres() {
    const std::vector<DelaunayTriangle> triangles = mesh_.triangles();
    std::vector<Wanted> wanted;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto [a, b, c] = triangles[t].vertex;
      const Circle circle = circumcircle(at(a), at(b), at(c));
      const double large = largeness(triangles[t], circle);
      if (large > tolerable_radius) wanted.push_back({large, static_cast<int>(t), a, circle.centre});
    }
    return wanted;
  }

  bool insert(std::vector<Wanted> wanted) {
    std::sort(wanted.begin(), wanted.end(), [](const Wanted& x, const Wanted& y) {
      return std::pair(-x.urgency, x.triangle) < std::pair(-y.urgency, y.triangle);
    });
    bool inserted = false;
    for (const Wanted& w : wanted) {
      if (!w.place.allFinite()) continue;
      const double size = sizing_.size(w.place);
      if (grid_.any_within(w.place, nearest_vertex * size) || !sizing_.inside(w.place, nearest_outline * size)) continue;
      grid_.add(w.place);
      mesh_.insert(w.place, w.near);
      points_.push_back(w.place);
      near_.push_back(w.near);
      inserted = true;
    }
    return inserted;
  }

  Sizing sizing_;
  PointGrid grid_;
  ConstrainedDelaunay mesh_;
  std::vector<Eigen::Vector2d> points_;
  std::vector<int> near_;
};

}  // namespace

Filling fill(const std::vector<Eigen::Vector2d>& loop, double edge_length, double smallest_angle) {
  Front front(loop, edge_length);
  front.advance();
  return smooth(front.points(), front.near(), static_cast<int>(loop.size()), smoothing_rounds, smallest_angle);
}

}  // namespace toile
