// Edits that keep the style against deformations that keep the surface rigid, both with the same vertices held (paper Fig. 3).

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "edit/as_rigid_as_possible.h"
#include "edit/operation.h"
#include "edit/worn_skirt.h"
#include "geometry/topology.h"
#include "style/normal_deviation.h"

namespace toile {
namespace {

// Sum of absolute angle defects at inner vertices, radians.
Eigen::VectorXd angle_defects(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xi& triangles) {
  Eigen::VectorXd defect = Eigen::VectorXd::Constant(x.cols(), 2 * M_PI);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = x.col(triangles(k, t)), u = x.col(triangles((k + 1) % 3, t)) - a,
                            v = x.col(triangles((k + 2) % 3, t)) - a;
      defect(triangles(k, t)) -= std::atan2(u.cross(v).norm(), u.dot(v));
    }
  for (const auto& edge : boundary_loops(triangles))
    for (const int v : edge) defect(v) = 0;
  return defect;
}

struct Compared {
  double turned = 0, rigid_turned = 0;  // radians, mean of normals
  double curved = 0, rigid_curved = 0;  // radians, sum of changes of angle defects
  double added = 0, rigid_added = 0;    // likewise of what defects grew by: Gaussian curvature the source did not have
};

// The edit, and the same loop and everything that did not move held while the rest is as rigid as possible.
Compared compared(const std::string& operation, const EditArguments& arguments) {
  static const testing::WornSkirt scene({.columns = 64, .rows = 40, .jitter = .2});
  const Target target = scene.apply(operation, arguments);
  std::set<int> held(target.held.begin(), target.held.end());
  for (Eigen::Index v = 0; v < target.positions.cols(); ++v)
    if ((target.positions.col(v) - target.source.col(v)).norm() < 1e-9) held.insert(static_cast<int>(v));
  const std::vector<int> vertices(held.begin(), held.end());
  Eigen::Matrix3Xd to(3, static_cast<Eigen::Index>(vertices.size()));
  for (Eigen::Index i = 0; i < to.cols(); ++i) to.col(i) = target.positions.col(vertices[static_cast<std::size_t>(i)]);
  const Eigen::Matrix3Xi& triangles = target.garment.triangles;
  const Eigen::Matrix3Xd rigid = testing::as_rigid_as_possible(target.source, triangles, vertices, to);
  const auto sources = source_triangles(target.source, triangles);
  const Eigen::VectorXd before = angle_defects(target.source, triangles);
  return {normal_deviation(sources, target.source, target.positions).mean,
          normal_deviation(sources, target.source, rigid).mean,
          (angle_defects(target.positions, triangles) - before).cwiseAbs().sum(),
          (angle_defects(rigid, triangles) - before).cwiseAbs().sum(),
          (angle_defects(target.positions, triangles).cwiseAbs() - before.cwiseAbs()).cwiseMax(0).sum(),
          (angle_defects(rigid, triangles).cwiseAbs() - before.cwiseAbs()).cwiseMax(0).sum()};
}

TEST(StyleAgainstRigid, ShorterTurnsNormalsAndCurvesLess) {
  const Compared c = compared("length", {{"loop", "hem"}, {"by", "-10 cm"}});
  EXPECT_LT(c.turned, c.rigid_turned / 2);
  EXPECT_LT(c.curved, c.rigid_curved / 2);
  EXPECT_LT(c.added, c.rigid_added / 2);
}

// Cloth carried straight on beyond the hem keeps the folds' directions, not their curvature: here the rigid deformation has the
// better of it.
TEST(StyleAgainstRigid, LongerTurnsNormalsLess) {
  const Compared c = compared("length", {{"loop", "hem"}, {"by", "10 cm"}});
  EXPECT_LT(c.turned, .8 * c.rigid_turned);
}

TEST(StyleAgainstRigid, AWiderHemTurnsNormalsAndCurvesLess) {
  const Compared c = compared("fit", {{"loop", "hem"}, {"by", "2 cm"}});
  EXPECT_LT(c.turned, .8 * c.rigid_turned);
  EXPECT_LT(c.curved, c.rigid_curved);
  EXPECT_LT(c.added, c.rigid_added);
}

}  // namespace
}  // namespace toile
