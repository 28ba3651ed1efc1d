#include "edit/mix/blend.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "body/triangle_tree.h"

namespace toile {
namespace {

constexpr double same_cloth = 0.05;   // m, beyond which the other garment is not there
constexpr double least_alike = 0.7;   // cosine between the normals of both cloths: beyond 45 degrees a fold of the one has no
                                      // counterpart in the other
constexpr double blend_weight = 100;  // against E_shape = 1, as contact

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

Eigen::Vector3d area_vector(const Eigen::Matrix3Xd& x, const Eigen::Vector3i& t) {
  const Eigen::Vector3d a = x.col(t(0));
  return Eigen::Vector3d(x.col(t(1)) - a).cross(x.col(t(2)) - a);
}

}  // namespace

std::vector<SoftTerm> alignment_terms(const Body& body, const JoinedGarment& joined, const Eigen::Matrix3Xd& positions,
                                      const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& areas, const EditInput& first,
                                      const EditInput& second) {
  const double tau = blend_share * body.form.height, length = style_weights(body.form.height).length;
  const JointEdge edges[2] = {{joined, 0}, {joined, 1}};
  const EditInput* whole[2] = {&first, &second};
  const TriangleTree cloth[2] = {{first.drape, first.garment.triangles}, {second.drape, second.garment.triangles}};
  const std::vector<int> offsets = triangle_offsets(joined.garment);
  std::vector<int> side(static_cast<std::size_t>(positions.cols()), -1);
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, positions.cols());
  for (std::size_t p = 0; p < joined.garment.panels.size(); ++p)
    for (Eigen::Index t = offsets[p]; t < offsets[p + 1]; ++t)
      for (int k = 0; k < 3; ++k) {
        side[static_cast<std::size_t>(triangles(k, t))] = joined.side[p];
        normals.col(triangles(k, t)) += area_vector(positions, triangles.col(t));
      }
  std::vector<SoftTerm> terms;
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const int own = side[static_cast<std::size_t>(v)];
    if (own < 0) continue;
    const Eigen::Vector3d at = positions.col(v);
    const double near = edges[own].distance(at);
    if (near >= tau) continue;
    const NearestPoint other = cloth[1 - own].nearest(at, same_cloth);
    if (other.triangle < 0) continue;
    const double far = std::max(near, edges[1 - own].distance(other.at));
    const EditInput& of = *whole[1 - own];
    const Eigen::Vector3d normal = area_vector(of.drape, of.garment.triangles.col(other.triangle)).normalized(),
                          way = other.at - at;
    const bool beside_its_end = std::abs(way.dot(normal)) < least_alike * way.norm() && way.norm() > 1e-4;
    if (far >= tau || beside_its_end || normal.dot(normals.col(v).normalized()) < least_alike) continue;
    const double weight = blend_weight * (1 - far * far / (tau * tau)) * areas(v) / (length * length);
    terms.push_back({static_cast<int>(v), normal, normal.dot(at + other.at) / 2, weight});
  }
  return terms;
}

}  // namespace toile
