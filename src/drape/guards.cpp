#include "drape/guards.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collide/intersections.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double held_within = 5e-3;  // m from the body: counts as resting on it

Eigen::Vector3d area_normal(const GarmentMesh& garment, const Eigen::Matrix3Xd& x, Eigen::Index t) {
  const auto corner = garment.triangles.col(t);
  const Eigen::Vector3d a = x.col(corner(0));
  return (Eigen::Vector3d(x.col(corner(1))) - a).cross(Eigen::Vector3d(x.col(corner(2))) - a);
}

}  // namespace

double max_penetration(const GarmentMesh& garment, const Eigen::Matrix3Xd& x, const Body& body) {
  double deepest = 0;
  const auto probe = [&](const Eigen::Vector3d& at) { deepest = std::max(deepest, -body.distance.distance(at)); };
  for (Eigen::Index v = 0; v < x.cols(); ++v) probe(x.col(v));
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    const auto corner = garment.triangles.col(t);
    for (int i = 0; i < 3; ++i) probe((x.col(corner(i)) + x.col(corner((i + 1) % 3))) / 2);
    probe((x.col(corner(0)) + x.col(corner(1)) + x.col(corner(2))) / 3);
  }
  return deepest;
}

int inverted_triangles(const GarmentMesh& garment, const Eigen::Matrix3Xd& x) {
  std::vector<Eigen::Vector3d> around(static_cast<std::size_t>(garment.triangles.cols()), Eigen::Vector3d::Zero());
  for (const MeshEdge& edge : mesh_edges(garment.triangles)) {
    if (edge.triangle[1] < 0) continue;
    for (std::size_t s = 0; s < 2; ++s)
      around[static_cast<std::size_t>(edge.triangle[s])] += area_normal(garment, x, edge.triangle[1 - s]);
  }
  int count = 0;
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    const Eigen::Vector3d normal = area_normal(garment, x, t);
    const Eigen::Vector3d& mean = around[static_cast<std::size_t>(t)];
    if (normal.dot(mean) < -0.866 * normal.norm() * mean.norm()) ++count;
  }
  return count;
}

void measure_guards(const DrapeRequest& request, Drape& drape) {
  if (drape.positions.cols() != request.start.cols())
    throw std::runtime_error(drape.simulator + ": gave back another number of vertices");
  if (!drape.positions.allFinite()) throw std::runtime_error(drape.simulator + ": gave back positions that are not finite");
  drape.max_penetration = max_penetration(request.garment, drape.positions, request.body);
  drape.inverted_triangles = inverted_triangles(request.garment, drape.positions);
  drape.self_intersections = static_cast<int>(intersecting_triangles(drape.positions, request.garment.triangles).size());
  double drop = 0;
  int held = 0;
  for (Eigen::Index v = 0; v < request.start.cols(); ++v)
    if (request.body.distance.distance(request.start.col(v)) < held_within) {
      drop += request.start(1, v) - drape.positions(1, v);
      ++held;
    }
  drape.slipped = held > 0 ? std::max(0.0, drop / held) : 0;
}

}  // namespace toile
