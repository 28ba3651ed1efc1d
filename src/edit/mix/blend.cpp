#include "edit/mix/blend.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "body/triangle_tree.h"

namespace toile {
namespace {

constexpr double same_cloth = 0.05;  // m, beyond which the other garment is not there
constexpr double least_alike = 0.7;  // cosine between the normals of both cloths: beyond 45 degrees a fold of the one has no
                                     // counterpart in the other
constexpr double least_area = 0.5;   // of the one cloth's triangle on the other, and the most its inverse

// The edge of one part along the joint, piece by piece.
class JointEdge {
 public:
  JointEdge(const JoinedGarment& joined, int side) {
    const std::set<int> joint(joined.joint.begin(), joined.joint.end());
    const GarmentMesh& garment = joined.garment;
    const std::vector<int> offsets = triangle_offsets(garment);
    for (std::size_t p = 0; p < garment.panels.size(); ++p)
      for (int t = offsets[p]; joined.side[p] == side && t < offsets[p + 1]; ++t)
        for (int k = 0; k < 3; ++k) {
          const int a = garment.triangles(k, t), b = garment.triangles((k + 1) % 3, t);
          if (joint.count(a) && joint.count(b)) pieces_.emplace_back(joined.hanging[side].col(a), joined.hanging[side].col(b));
        }
  }

  double distance(const Eigen::Vector3d& at) const {
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : pieces_) {
      const Eigen::Vector3d way = b - a;
      const double t = std::clamp((at - a).dot(way) / std::max(1e-18, way.squaredNorm()), 0.0, 1.0);
      best = std::min(best, (a + t * way - at).squaredNorm());
    }
    return std::sqrt(best);
  }

 private:
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> pieces_;
};

Eigen::Vector3d normal_of(const SourceTriangle& triangle) { return triangle.plane.col(0).cross(triangle.plane.col(1)); }

}  // namespace

std::vector<SourceTriangle> blended_style(const Body& body, const JoinedGarment& joined, const Eigen::Matrix3Xd& positions,
                                          const Eigen::Matrix3Xi& triangles, const EditInput& first, const EditInput& second) {
  const double tau = blend_share * body.form.height;
  const JointEdge edges[2] = {{joined, 0}, {joined, 1}};
  const TriangleTree cloth[2] = {{first.drape, first.garment.triangles}, {second.drape, second.garment.triangles}};
  const std::vector<int> offsets = triangle_offsets(joined.garment);
  std::vector<SourceTriangle> found;
  for (std::size_t p = 0; p < joined.garment.panels.size(); ++p) {
    const int side = joined.side[p];
    for (Eigen::Index t = offsets[p]; t < offsets[p + 1]; ++t) {
      Eigen::Matrix3d own, other;
      for (int k = 0; k < 3; ++k) own.col(k) = positions.col(triangles(k, t));
      const double near = edges[side].distance(own.rowwise().mean());
      if (near >= tau) continue;
      bool there = true;
      for (int k = 0; k < 3 && there; ++k) {
        const NearestPoint met = cloth[1 - side].nearest(own.col(k), same_cloth);
        there = met.triangle >= 0;
        other.col(k) = met.at;
      }
      if (!there) continue;
      const double far = std::max(near, edges[1 - side].distance(other.rowwise().mean()));
      const auto of_own = source_triangles(own, Eigen::Vector3i(0, 1, 2)),
                 of_other = source_triangles(other, Eigen::Vector3i(0, 1, 2));
      if (far >= tau || of_own.empty() || of_other.empty()) continue;
      const double area = of_other[0].area / of_own[0].area;
      if (area < least_area || area > 1 / least_area || normal_of(of_own[0]).dot(normal_of(of_other[0])) < least_alike)
        continue;
      SourceTriangle triangle = of_other[0];
      triangle.corners = triangles.col(t);
      triangle.area = of_own[0].area * (1 - far * far / (tau * tau));
      found.push_back(triangle);
    }
  }
  return found;
}

}  // namespace toile
