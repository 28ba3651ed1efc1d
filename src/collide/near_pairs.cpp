#include "collide/near_pairs.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "collide/closest_points.h"
#include "geometry/topology.h"

namespace toile {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
using Found = std::vector<std::pair<int, int>>;

template <class Corners>
Box box_round(const Eigen::Matrix3Xd& x, const Corners& corners, double reach, int info) {
  Eigen::Vector3d low = x.col(corners(0));
  Eigen::Vector3d high = low;
  for (Eigen::Index i = 1; i < corners.size(); ++i) {
    low = low.cwiseMin(x.col(corners(i)));
    high = high.cwiseMax(x.col(corners(i)));
  }
  low.array() -= reach;
  high.array() += reach;
  return Box(low.data(), high.data(), info);
}

NearPair pair_of(const Eigen::Matrix3Xd& x, std::array<int, 4> vertex, int first, const ClosestPoints& closest) {
  NearPair pair{.vertex = vertex, .first = first, .weight = closest.weight, .distance = closest.distance};
  if (closest.distance > 0) pair.normal = closest.apart / closest.distance;
  for (int i = first; i < 4; ++i) pair.middle += closest.weight(i) * x.col(vertex[static_cast<std::size_t>(i)]);
  pair.middle += closest.apart / 2;
  return pair;
}

}  // namespace

CollisionMesh collision_mesh(const Eigen::Matrix3Xi& triangles, int vertex_count, std::vector<int> group) {
  CollisionMesh mesh;
  mesh.triangles = triangles;
  const auto edges = mesh_edges(triangles);
  mesh.edges.resize(2, static_cast<Eigen::Index>(edges.size()));
  for (std::size_t e = 0; e < edges.size(); ++e)
    mesh.edges.col(static_cast<Eigen::Index>(e)) << edges[e].vertex[0], edges[e].vertex[1];
  mesh.corners.assign(triangles.data(), triangles.data() + triangles.size());
  std::sort(mesh.corners.begin(), mesh.corners.end());
  mesh.corners.erase(std::unique(mesh.corners.begin(), mesh.corners.end()), mesh.corners.end());
  if (group.empty()) {
    group.resize(static_cast<std::size_t>(vertex_count));
    std::iota(group.begin(), group.end(), 0);
  }
  mesh.group = std::move(group);
  return mesh;
}

std::vector<NearPair> near_pairs(const Eigen::Matrix3Xd& x, const CollisionMesh& mesh, double distance) {
  const auto group = [&](int v) { return mesh.group[static_cast<std::size_t>(v)]; };
  std::vector<NearPair> pairs;
  std::vector<Box> points, faces, edges;
  for (const int v : mesh.corners) points.push_back(box_round(x, Eigen::Matrix<int, 1, 1>(v), distance / 2, v));
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    faces.push_back(box_round(x, mesh.triangles.col(t), distance / 2, static_cast<int>(t)));
  for (Eigen::Index e = 0; e < mesh.edges.cols(); ++e)
    edges.push_back(box_round(x, mesh.edges.col(e), distance / 2, static_cast<int>(e)));

  CGAL::box_intersection_d(points.begin(), points.end(), faces.begin(), faces.end(), [&](const Box& point, const Box& face) {
    const int v = point.info();
    const Eigen::Vector3i c = mesh.triangles.col(face.info());
    if (group(v) == group(c(0)) || group(v) == group(c(1)) || group(v) == group(c(2))) return;
    const auto closest = closest_to_triangle(x.col(v), x.col(c(0)), x.col(c(1)), x.col(c(2)));
    if (closest.distance < distance) pairs.push_back(pair_of(x, {v, c(0), c(1), c(2)}, 1, closest));
  });
  CGAL::box_self_intersection_d(edges.begin(), edges.end(), [&](const Box& one, const Box& other) {
    const Eigen::Vector2i a = mesh.edges.col(std::min(one.info(), other.info()));
    const Eigen::Vector2i b = mesh.edges.col(std::max(one.info(), other.info()));
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (group(a(i)) == group(b(j))) return;
    const auto closest = closest_of_segments(x.col(a(0)), x.col(a(1)), x.col(b(0)), x.col(b(1)));
    if (closest.distance < distance) pairs.push_back(pair_of(x, {a(0), a(1), b(0), b(1)}, 2, closest));
  });
  std::sort(pairs.begin(), pairs.end(),
            [](const NearPair& a, const NearPair& b) { return std::tie(a.first, a.vertex) < std::tie(b.first, b.vertex); });
  return pairs;
}

}  // namespace toile
