#include "triangulate/fill.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "geometry/topology.h"
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

using Triangle = std::array<int, 3>;

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
      : corners_(static_cast<int>(loop.size())), sizing_(loop, edge_length), grid_(edge_length / 2), points_(loop) {
    for (const Eigen::Vector2d& p : loop) grid_.add(p);
  }

  // Triangles on the outline first, then on those already good, until no triangle too large has a place for a point.
  void advance() {
    while (round_of_front()) {
    }
    while (round_of_circumcentres()) {
    }
  }

  const std::vector<Eigen::Vector2d>& points() const { return points_; }
  const Sizing& sizing() const { return sizing_; }

 private:
  struct Wanted {
    double urgency;
    int triangle;
    Eigen::Vector2d place;
  };

  Eigen::Vector2d at(int vertex) const { return points_[static_cast<std::size_t>(vertex)]; }

  bool round_of_front() {
    const std::vector<Triangle> triangles = constrained_delaunay(points_, corners_);
    const std::size_t n = triangles.size();
    std::vector<Circle> circles(n);
    std::vector<double> sizes(n);
    Eigen::Matrix3Xi columns(3, static_cast<Eigen::Index>(n));
    for (std::size_t t = 0; t < n; ++t) {
      const auto [a, b, c] = triangles[t];
      columns.col(static_cast<Eigen::Index>(t)) << a, b, c;
      circles[t] = circumcircle(at(a), at(b), at(c));
      sizes[t] = sizing_.size((at(a) + at(b) + at(c)) / 3);
    }
    const auto good = [&](int t) {
      return circles[static_cast<std::size_t>(t)].radius <= good_radius * sizes[static_cast<std::size_t>(t)];
    };
    std::vector<std::optional<MeshEdge>> base(n);  // shortest side on the front
    std::vector<int> base_side(n, 0);
    for (const MeshEdge& edge : mesh_edges(columns))
      for (int side = 0; side < 2; ++side) {
        const int t = edge.triangle[static_cast<std::size_t>(side)], other = edge.triangle[static_cast<std::size_t>(1 - side)];
        if (t < 0 || good(t) || (other >= 0 && !good(other))) continue;
        auto& best = base[static_cast<std::size_t>(t)];
        const auto length = [&](const MeshEdge& e) { return (at(e.vertex[1]) - at(e.vertex[0])).norm(); };
        if (best && length(*best) <= length(edge)) continue;
        best = edge;
        base_side[static_cast<std::size_t>(t)] = side;
      }
    std::vector<Wanted> wanted;
    for (std::size_t t = 0; t < n; ++t) {
      if (!base[t]) continue;
      int a = base[t]->vertex[0], b = base[t]->vertex[1];
      const auto& corners = triangles[t];
      const auto from = std::find(corners.begin(), corners.end(), a) - corners.begin();
      if (corners[static_cast<std::size_t>((from + 1) % 3)] != b) std::swap(a, b);
      const double size = sizing_.size((at(a) + at(b)) / 2);
      wanted.push_back({circles[t].radius / sizes[t], static_cast<int>(t), front_point(at(a), at(b), circles[t], size)});
    }
    return insert(std::move(wanted), nearest_vertex, nearest_outline);
  }

  bool round_of_circumcentres() {
    const std::vector<Triangle> triangles = constrained_delaunay(points_, corners_);
    std::vector<Wanted> wanted;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto [a, b, c] = triangles[t];
      const Circle circle = circumcircle(at(a), at(b), at(c));
      const double size = sizing_.size((at(a) + at(b) + at(c)) / 3);
      if (circle.radius > tolerable_radius * size) wanted.push_back({circle.radius / size, static_cast<int>(t), circle.centre});
    }
    return insert(std::move(wanted), nearest_vertex, nearest_outline);
  }

  bool insert(std::vector<Wanted> wanted, double from_vertices, double from_outline) {
    std::sort(wanted.begin(), wanted.end(), [](const Wanted& x, const Wanted& y) {
      return std::pair(-x.urgency, x.triangle) < std::pair(-y.urgency, y.triangle);
    });
    bool inserted = false;
    for (const Wanted& w : wanted) {
      if (!w.place.allFinite()) continue;
      const double size = sizing_.size(w.place);
      if (grid_.any_within(w.place, from_vertices * size) || !sizing_.inside(w.place, from_outline * size)) continue;
      grid_.add(w.place);
      points_.push_back(w.place);
      inserted = true;
    }
    return inserted;
  }

  int corners_;
  Sizing sizing_;
  PointGrid grid_;
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace

Filling fill(const std::vector<Eigen::Vector2d>& loop, double edge_length, double smallest_angle) {
  Front front(loop, edge_length);
  front.advance();
  return smooth({front.points(), {}}, static_cast<int>(loop.size()), smoothing_rounds, smallest_angle);
}

}  // namespace toile
