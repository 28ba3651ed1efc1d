#include "edit/mix/blend.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "body/relative.h"
#include "body/triangle_tree.h"

namespace toile {
namespace {

constexpr double same_cloth = 0.05;  // m along the ray, beyond which the other garment is not there

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

// Where the other garment crosses the ray from the bone through the point, nearest to it.
std::optional<Eigen::Vector3d> counterpart(const Body& body, const TriangleTree& cloth, const Eigen::Vector3d& at) {
  const Eigen::Vector3d from = relative_place(body, at).on_axis, step = at - from;
  if (!(step.norm() > 1e-6)) return std::nullopt;
  const double reach = same_cloth / step.norm();
  double best = std::numeric_limits<double>::infinity();
  for (const double t : cloth.crossings(from, step, 1 + reach))
    if (std::abs(t - 1) < std::abs(best - 1)) best = t;
  if (!(std::abs(best - 1) <= reach)) return std::nullopt;
  return Eigen::Vector3d(from + best * step);
}

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
        const auto met = counterpart(body, cloth[1 - side], own.col(k));
        there = met.has_value();
        if (met) other.col(k) = *met;
      }
      if (!there) continue;
      const double far = std::max(near, edges[1 - side].distance(other.rowwise().mean()));
      const auto of_own = source_triangles(own, Eigen::Vector3i(0, 1, 2)),
                 of_other = source_triangles(other, Eigen::Vector3i(0, 1, 2));
      if (far >= tau || of_own.empty() || of_other.empty() || normal_of(of_own[0]).dot(normal_of(of_other[0])) <= 0) continue;
      SourceTriangle triangle = of_other[0];
      triangle.corners = triangles.col(t);
      triangle.area = of_own[0].area * (1 - far * far / (tau * tau));
      found.push_back(triangle);
    }
  }
  return found;
}

}  // namespace toile
