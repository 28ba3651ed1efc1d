#include "collide/near_pairs.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <future>
#include <numeric>
#include <utility>

#include "collide/closest_points.h"
#include "geometry/topology.h"

namespace toile {
namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
constexpr std::ptrdiff_t scan_below = 400;  // boxes: CGAL's cutoff, fastest for meshes of 10,000 to 60,000 triangles
// CGAL sorts what it is given: pointers are cheaper to move than boxes.
std::vector<const Box*> handles(const std::vector<Box>& boxes) {
  std::vector<const Box*> list;
  list.reserve(boxes.size());
  for (const Box& box : boxes) list.push_back(&box);
  return list;
}

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

template <class One, class Other>
bool boxes_near(const Eigen::Matrix3Xd& x, const One& one, const Other& other, double distance) {
  for (int k = 0; k < 3; ++k) {
    double low = x(k, one(0)), high = low, other_low = x(k, other(0)), other_high = other_low;
    for (Eigen::Index i = 1; i < one.size(); ++i) {
      low = std::min(low, x(k, one(i)));
      high = std::max(high, x(k, one(i)));
    }
    for (Eigen::Index i = 1; i < other.size(); ++i) {
      other_low = std::min(other_low, x(k, other(i)));
      other_high = std::max(other_high, x(k, other(i)));
    }
    if (low > other_high + distance || other_low > high + distance) return false;
  }
  return true;
}

using List = std::vector<std::array<int, 2>>;

// Vertex and triangle, without a common group, whose boxes grown by `reach` meet.
List points_by_faces(const Eigen::Matrix3Xd& x, const CollisionMesh& mesh, double reach) {
  std::vector<Box> points, faces;
  points.reserve(mesh.corners.size());
  faces.reserve(static_cast<std::size_t>(mesh.triangles.cols()));
  for (const int v : mesh.corners) points.push_back(box_round(x, Eigen::Matrix<int, 1, 1>(v), reach, v));
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    faces.push_back(box_round(x, mesh.triangles.col(t), reach, static_cast<int>(t)));
  auto point_list = handles(points);
  auto face_list = handles(faces);
  List found;
  const auto group = [&](int v) { return mesh.group[static_cast<std::size_t>(v)]; };
  CGAL::box_intersection_d(
      point_list.begin(), point_list.end(), face_list.begin(), face_list.end(),
      [&](const Box* point, const Box* face) {
        const int g = group(point->info());
        const auto c = mesh.triangles.col(face->info());
        if (g == group(c(0)) || g == group(c(1)) || g == group(c(2))) return;
        found.push_back({point->info(), face->info()});
      },
      CGAL::Box_intersection_d::Box_traits_d<const Box*>(), scan_below);
  return found;
}

List edges_by_edges(const Eigen::Matrix3Xd& x, const CollisionMesh& mesh, double reach) {
  std::vector<Box> edges;
  edges.reserve(static_cast<std::size_t>(mesh.edges.cols()));
  for (Eigen::Index e = 0; e < mesh.edges.cols(); ++e)
    edges.push_back(box_round(x, mesh.edges.col(e), reach, static_cast<int>(e)));
  auto list = handles(edges);
  List found;
  const auto group = [&](int v) { return mesh.group[static_cast<std::size_t>(v)]; };
  CGAL::box_self_intersection_d(
      list.begin(), list.end(),
      [&](const Box* one, const Box* other) {
        const auto a = mesh.edges.col(one->info());
        const auto b = mesh.edges.col(other->info());
        for (int i = 0; i < 2; ++i)
          for (int j = 0; j < 2; ++j)
            if (group(a(i)) == group(b(j))) return;
        found.push_back({std::min(one->info(), other->info()), std::max(one->info(), other->info())});
      },
      CGAL::Box_intersection_d::Box_traits_d<const Box*>(), scan_below);
  return found;
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
  auto edges = mesh_edges(triangles);
  edges.erase(std::remove_if(edges.begin(), edges.end(), [](const MeshEdge& edge) { return edge.further != -1; }), edges.end());
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

NearPairSearch::NearPairSearch(CollisionMesh mesh, double distance, double margin)
    : mesh_(std::move(mesh)), distance_(distance), listing_(margin) {}

std::vector<NearPair> NearPairSearch::find(const Eigen::Matrix3Xd& x) {
  if (const auto margin = listing_.renew(x)) {
    const double reach = distance_ / 2 + *margin;
    auto points = std::async(std::launch::async, [&] { return points_by_faces(x, mesh_, reach); });
    edge_edge_ = edges_by_edges(x, mesh_, reach);
    point_face_ = points.get();
  }
  std::vector<NearPair> pairs;
  for (const auto& [v, t] : point_face_) {
    const Eigen::Vector3i c = mesh_.triangles.col(t);
    if (!boxes_near(x, Eigen::Matrix<int, 1, 1>(v), c, distance_)) continue;
    const auto closest = closest_to_triangle(x.col(v), x.col(c(0)), x.col(c(1)), x.col(c(2)));
    if (closest.distance < distance_) pairs.push_back(pair_of(x, {v, c(0), c(1), c(2)}, 1, closest));
  }
  for (const auto& [e, f] : edge_edge_) {
    const Eigen::Vector2i a = mesh_.edges.col(e);
    const Eigen::Vector2i b = mesh_.edges.col(f);
    if (!boxes_near(x, a, b, distance_)) continue;
    const auto closest = closest_of_segments(x.col(a(0)), x.col(a(1)), x.col(b(0)), x.col(b(1)));
    if (closest.distance < distance_) pairs.push_back(pair_of(x, {a(0), a(1), b(0), b(1)}, 2, closest));
  }
  std::sort(pairs.begin(), pairs.end(),
            [](const NearPair& a, const NearPair& b) { return std::tie(a.first, a.vertex) < std::tie(b.first, b.vertex); });
  return pairs;
}

std::vector<NearPair> near_pairs(const Eigen::Matrix3Xd& x, const CollisionMesh& mesh, double distance) {
  return NearPairSearch(mesh, distance, 0).find(x);
}

}  // namespace toile
