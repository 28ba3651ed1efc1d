#include "collide/intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <utility>

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

constexpr std::ptrdiff_t scan_below = 400;  // boxes: CGAL's cutoff

struct Triangles {
  const Eigen::Matrix3Xd& x;
  const Eigen::Matrix3Xi& corner;

  Kernel::Point_3 at(int v) const { return {x(0, v), x(1, v), x(2, v)}; }
  Kernel::Triangle_3 triangle(int t) const { return {at(corner(0, t)), at(corner(1, t)), at(corner(2, t))}; }
  bool flat(int t) const { return CGAL::collinear(at(corner(0, t)), at(corner(1, t)), at(corner(2, t))); }
};

// All of `points` (columns) on one side of the plane through `on` square to `normal`, farther off than rounding could hide:
// +1 or -1, else 0.
int side(const Eigen::Vector3d& normal, const Eigen::Vector3d& on, const Eigen::Matrix3d& points, int count) {
  const double clear = 1e-11 * normal.norm();  // m, for a cloth some metres from the origin
  bool above = true, below = true;
  for (int i = 0; i < count; ++i) {
    const double height = normal.dot(points.col(i) - on);
    above = above && height > clear;
    below = below && height < -clear;
  }
  return above ? 1 : below ? -1 : 0;
}

// A cheap proof that triangles meet nowhere but in `shared` corners (none or one, the first column of each).
bool parted(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b, int shared) {
  const Eigen::Matrix3d far_a = shared ? Eigen::Matrix3d(a(Eigen::all, {1, 2, 0})) : a;
  const Eigen::Matrix3d far_b = shared ? Eigen::Matrix3d(b(Eigen::all, {1, 2, 0})) : b;
  const int count = 3 - shared;
  if (shared) {
    const Eigen::Vector3d between =
        (b.col(1) + b.col(2) - 2 * b.col(0)).normalized() - (a.col(1) + a.col(2) - 2 * a.col(0)).normalized();
    if (side(between, a.col(0), far_a, count) < 0 && side(between, a.col(0), far_b, count) > 0) return true;
  }
  const auto normal = [](const Eigen::Matrix3d& t) -> Eigen::Vector3d {
    return (t.col(1) - t.col(0)).cross(t.col(2) - t.col(0));
  };
  return side(normal(a), a.col(0), far_b, count) != 0 || side(normal(b), b.col(0), far_a, count) != 0;
}

// Does the edge of `t` off its corner `shared` meet triangle `other`? Two triangles with a common corner that meet anywhere
// else also meet there, on the one or the other.
bool far_edge_meets(const Triangles& mesh, int t, int shared, int other) {
  std::array<int, 2> far{};
  std::size_t n = 0;
  for (int i = 0; i < 3; ++i)
    if (mesh.corner(i, t) != shared) far[n++] = mesh.corner(i, t);
  return CGAL::do_intersect(Kernel::Segment_3(mesh.at(far[0]), mesh.at(far[1])), mesh.triangle(other));
}

// Corners, the one numbered `first` in front.
Eigen::Matrix3d corners(const Triangles& mesh, int t, int first) {
  Eigen::Matrix3d c;
  for (int i = 0; i < 3; ++i) c.col(i) = mesh.x.col(mesh.corner((first + i) % 3, t));
  return c;
}

bool share_edge(const Triangles& mesh, int a, int b) {
  int common = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) common += mesh.corner(i, a) == mesh.corner(j, b);
  return common > 1;
}

bool meet(const Triangles& mesh, int a, int b) {
  int common = 0, first_a = 0, first_b = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (mesh.corner(i, a) == mesh.corner(j, b)) ++common, first_a = i, first_b = j;
  if (common > 1 || parted(corners(mesh, a, first_a), corners(mesh, b, first_b), common)) return false;
  if (mesh.flat(a) || mesh.flat(b)) return false;
  if (common == 0) return CGAL::do_intersect(mesh.triangle(a), mesh.triangle(b));
  const int shared = mesh.corner(first_a, a);
  return far_edge_meets(mesh, a, shared, b) || far_edge_meets(mesh, b, shared, a);
}

// Calls visit(a, b), a < b, for triangles whose boxes grown by `reach` meet.
template <class Visit>
void for_near_triangles(const Triangles& mesh, double reach, const Visit& visit) {
  std::vector<Box> boxes;
  boxes.reserve(static_cast<std::size_t>(mesh.corner.cols()));
  for (int t = 0; t < static_cast<int>(mesh.corner.cols()); ++t) {
    const Eigen::Matrix3d x = corners(mesh, t, 0);
    Eigen::Vector3d low = x.rowwise().minCoeff().array() - reach;
    Eigen::Vector3d high = x.rowwise().maxCoeff().array() + reach;
    boxes.emplace_back(low.data(), high.data(), t);
  }
  std::vector<const Box*> list;  // CGAL sorts what it is given
  list.reserve(boxes.size());
  for (const Box& box : boxes) list.push_back(&box);
  CGAL::box_self_intersection_d(
      list.begin(), list.end(),
      [&](const Box* one, const Box* other) {
        visit(std::min(one->info(), other->info()), std::max(one->info(), other->info()));
      },
      CGAL::Box_intersection_d::Box_traits_d<const Box*>(), scan_below);
}

}  // namespace

std::vector<std::pair<int, int>> intersecting_triangles(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  const Triangles mesh{positions, triangles};
  std::vector<std::pair<int, int>> found;
  for_near_triangles(mesh, 0, [&](int a, int b) {
    if (meet(mesh, a, b)) found.emplace_back(a, b);
  });
  std::sort(found.begin(), found.end());
  return found;
}

IntersectionSearch::IntersectionSearch(Eigen::Matrix3Xi triangles, double margin)
    : triangles_(std::move(triangles)), listing_(margin) {}

bool IntersectionSearch::any(const Eigen::Matrix3Xd& positions) {
  const Triangles mesh{positions, triangles_};
  if (const auto margin = listing_.renew(positions)) {
    near_.clear();
    for_near_triangles(mesh, *margin, [&](int a, int b) {
      if (!share_edge(mesh, a, b)) near_.emplace_back(a, b);
    });
  }
  const auto box = [&](int t) {
    const Eigen::Matrix3d x = corners(mesh, t, 0);
    return std::pair<Eigen::Array3d, Eigen::Array3d>(x.rowwise().minCoeff(), x.rowwise().maxCoeff());
  };
  return std::any_of(near_.begin(), near_.end(), [&](const auto& pair) {
    const auto [low_a, high_a] = box(pair.first);
    const auto [low_b, high_b] = box(pair.second);
    return (low_a <= high_b).all() && (low_b <= high_a).all() && meet(mesh, pair.first, pair.second);
  });
}

}  // namespace toile
