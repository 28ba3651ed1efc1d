#include "collide/intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;

struct Triangles {
  const Eigen::Matrix3Xd& x;
  const Eigen::Matrix3Xi& corner;

  Kernel::Point_3 at(int v) const { return {x(0, v), x(1, v), x(2, v)}; }
  Kernel::Triangle_3 triangle(int t) const { return {at(corner(0, t)), at(corner(1, t)), at(corner(2, t))}; }
  bool flat(int t) const { return CGAL::collinear(at(corner(0, t)), at(corner(1, t)), at(corner(2, t))); }
};

// Does the edge of `t` off its corner `shared` meet triangle `other`? Two triangles with a common corner that meet anywhere
// else also meet there, on the one or the other.
bool far_edge_meets(const Triangles& mesh, int t, int shared, int other) {
  std::array<int, 2> far{};
  std::size_t n = 0;
  for (int i = 0; i < 3; ++i)
    if (mesh.corner(i, t) != shared) far[n++] = mesh.corner(i, t);
  return CGAL::do_intersect(Kernel::Segment_3(mesh.at(far[0]), mesh.at(far[1])), mesh.triangle(other));
}

bool meet(const Triangles& mesh, int a, int b) {
  int common = 0;
  int shared = -1;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (mesh.corner(i, a) == mesh.corner(j, b)) {
        ++common;
        shared = mesh.corner(i, a);
      }
  if (common > 1 || mesh.flat(a) || mesh.flat(b)) return false;
  if (common == 0) return CGAL::do_intersect(mesh.triangle(a), mesh.triangle(b));
  return far_edge_meets(mesh, a, shared, b) || far_edge_meets(mesh, b, shared, a);
}

}  // namespace

std::vector<std::pair<int, int>> intersecting_triangles(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  const Triangles mesh{positions, triangles};
  std::vector<Box> boxes;
  for (int t = 0; t < static_cast<int>(triangles.cols()); ++t) {
    const Eigen::Matrix3d x = positions(Eigen::all, triangles.col(t));
    Eigen::Vector3d low = x.rowwise().minCoeff();
    Eigen::Vector3d high = x.rowwise().maxCoeff();
    boxes.emplace_back(low.data(), high.data(), t);
  }
  std::vector<std::pair<int, int>> found;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& one, const Box& other) {
    const int a = std::min(one.info(), other.info());
    const int b = std::max(one.info(), other.info());
    if (meet(mesh, a, b)) found.emplace_back(a, b);
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace toile
