#include "drape/fem/bend_friction.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

namespace toile::fem {
namespace {

Hinge hinge() {
  Hinge h;
  h.vertex = {0, 1, 2, 3};
  return h;
}

// Edge of 12 mm along x, one triangle in the plane z = 0, the other turned out of it by `angle` about the edge.
Eigen::Matrix3Xd folded(double angle) {
  Eigen::Matrix3Xd x(3, 4);
  x.col(0) << 0, 0, 0;
  x.col(1) << .012, 0, 0;
  x.col(2) << .005, .009, 0;
  x.col(3) << .008, -.011 * std::cos(angle), .011 * std::sin(angle);
  return x;
}

class BentHinge : public testing::TestWithParam<double> {};

TEST_P(BentHinge, HasTheAngleItWasFoldedBy) {
  EXPECT_NEAR(std::abs(hinge_angle(hinge(), folded(GetParam()))), std::abs(GetParam()), 1e-12);
}

TEST_P(BentHinge, GradientAndHessianAreDifferenceQuotients) {
  const BendFriction friction{2e-4 * .012, .08};
  const double anchor = .15;
  Eigen::Matrix3Xd x = folded(GetParam());
  x.col(2) += Eigen::Vector3d(.001, -.0007, .0003);
  Vector12 gradient = Vector12::Zero();
  Matrix12 hessian = Matrix12::Zero();
  bend_friction_derivatives(friction, anchor, hinge(), x, Curvature::full, gradient, &hessian);
  const double h = 1e-7;
  for (int i = 0; i < 12; ++i) {
    Eigen::Matrix3Xd plus = x, minus = x;
    plus(i % 3, i / 3) += h;
    minus(i % 3, i / 3) -= h;
    EXPECT_NEAR(
        gradient(i),
        (bend_friction_energy(friction, anchor, hinge(), plus) - bend_friction_energy(friction, anchor, hinge(), minus)) /
            (2 * h),
        1e-6 * gradient.cwiseAbs().maxCoeff());
    Vector12 above = Vector12::Zero(), below = Vector12::Zero();
    bend_friction_derivatives(friction, anchor, hinge(), plus, Curvature::full, above, nullptr);
    bend_friction_derivatives(friction, anchor, hinge(), minus, Curvature::full, below, nullptr);
    EXPECT_NEAR((hessian.col(i) - (above - below) / (2 * h)).cwiseAbs().maxCoeff(), 0, 1e-5 * hessian.cwiseAbs().maxCoeff());
  }
}

TEST_P(BentHinge, ClampedHessianHasNoNegativeEigenvalue) {
  Vector12 ignored = Vector12::Zero();
  Matrix12 hessian = Matrix12::Zero();
  bend_friction_derivatives({2e-6, .08}, .15, hinge(), folded(GetParam()), Curvature::clamped, ignored, &hessian);
  const Eigen::SelfAdjointEigenSolver<Matrix12> solver(hessian);
  EXPECT_GE(solver.eigenvalues().minCoeff(), -1e-9 * solver.eigenvalues().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(Angles, BentHinge, testing::Values(-2.8, -.6, .02, .15, .9, 2.5));

TEST(BendFrictionForces, HaveNeitherResultantNorMoment) {
  Vector12 g = Vector12::Zero();
  const Eigen::Matrix3Xd x = folded(.7).colwise() + Eigen::Vector3d(.1, 1.2, -.3);
  bend_friction_derivatives({2e-6, .08}, .15, hinge(), x, Curvature::full, g, nullptr);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    sum += g.segment<3>(3 * i);
    moment += x.col(i).cross(g.segment<3>(3 * i));
  }
  EXPECT_NEAR(sum.norm(), 0, 1e-12 * g.norm());
  EXPECT_NEAR(moment.norm(), 0, 1e-12 * g.norm());
}

TEST(BendFrictionForces, AreNoneAtATriangleWithoutArea) {
  Eigen::Matrix3Xd x = folded(.7);
  x.col(2) << .004, 0, 0;
  Vector12 g = Vector12::Zero();
  Matrix12 hessian = Matrix12::Zero();
  bend_friction_derivatives({2e-6, .08}, .15, hinge(), x, Curvature::full, g, &hessian);
  EXPECT_EQ(g.norm(), 0);
  EXPECT_EQ(hessian.norm(), 0);
}

// Work to roll a sheet of equilateral triangles up, in the direction at `turn` to their edges, per moment x curvature x area.
struct Work {
  double sliding = 0, with_slack = 0;
};
Work work_to_roll(double turn) {
  const int columns = 60, rows = 60;
  const double dx = 6e-3, dy = dx * std::sqrt(.75), radius = .06;
  GarmentMesh garment;
  garment.vertex_count = (columns + 1) * (rows + 1);
  PanelMesh panel;
  panel.warp = Eigen::Vector2d::UnitY();
  panel.rest.resize(2, garment.vertex_count);
  Eigen::Matrix3Xd flat(3, garment.vertex_count), rolled(3, garment.vertex_count);
  const Eigen::Rotation2Dd rotation(turn);
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const int v = j * (columns + 1) + i;
      panel.rest.col(v) = rotation * Eigen::Vector2d(i * dx + (j % 2) * dx / 2, j * dy);
      const double s = panel.rest(0, v), y = panel.rest(1, v);
      flat.col(v) << s, y, 0;
      rolled.col(v) << radius * std::sin(s / radius), y, radius * (1 - std::cos(s / radius));
    }
  panel.triangles.resize(3, 2 * columns * rows);
  for (int j = 0, t = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int v = j * (columns + 1) + i, up = v + columns + 1;
      panel.triangles.col(t++) << v, v + 1, (j % 2 ? up + 1 : up);
      panel.triangles.col(t++) << (j % 2 ? v : v + 1), up + 1, up;
    }
  garment.triangles = panel.triangles;
  garment.welded.emplace_back(Eigen::VectorXi::LinSpaced(garment.vertex_count, 0, static_cast<int>(garment.vertex_count) - 1));
  garment.panels.push_back(panel);
  Fabric fabric;
  fabric.bend_friction = 3e-4;
  const auto hinges = bending_hinges(garment, fabric);
  const auto frictions = bend_frictions(garment, fabric, hinges);
  Work work;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    work.sliding += bend_friction_energy({frictions[h].moment, 0}, hinge_angle(hinges[h], flat), hinges[h], rolled);
    work.with_slack += bend_friction_energy(frictions[h], hinge_angle(hinges[h], flat), hinges[h], rolled);
  }
  const double whole = fabric.bend_friction / radius * (columns * dx) * (rows * dy);
  work.sliding /= whole;
  work.with_slack /= whole;
  return work;
}

TEST(BendFriction, TakesMomentTimesCurvatureTimesAreaToRollASheetOnAverage) {
  const double over = 1 / 3. + 2 * std::sqrt(3) / std::numbers::pi;
  EXPECT_NEAR(work_to_roll(0).sliding, 5 / 3. / over, .04);  // along an edge; the rims have hinges on one side only
  EXPECT_NEAR(work_to_roll(std::numbers::pi / 2).sliding, 1 / over, .04);
  double mean = 0;
  for (int i = 0; i < 12; ++i) mean += work_to_roll(i * std::numbers::pi / 36).sliding / 12;
  EXPECT_NEAR(mean, 1, .04);
}

TEST(BendFriction, IsASpringBeforeItSlides) {
  const Work work = work_to_roll(.3);
  EXPECT_GT(work.with_slack, .3 * work.sliding);
  EXPECT_LT(work.with_slack, .9 * work.sliding);
}

}  // namespace
}  // namespace toile::fem
