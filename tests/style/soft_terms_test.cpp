#include "style/soft_terms.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "style/hard_constraints.h"

namespace toile {
namespace {

const SkinPlace skin{{0.1, 1, 0.2}, Eigen::Vector3d(1, 0, 2).normalized()};

TEST(FitTerm, IsLeastAtTheGapItKeeps) {
  const StyleWeights weights = style_weights(1.7);
  const SoftTerm term = fit_term(0, skin, 5e-3, 1, 1e-4, weights);
  Eigen::Matrix3Xd at(3, 1);
  at.col(0) = skin.at + 5e-3 * skin.outward + 0.3 * Eigen::Vector3d(0, 1, 0);  // anywhere along the skin
  EXPECT_NEAR(soft_energy({term}, at), 0, 1e-18);
  at.col(0) += 2e-3 * skin.outward;
  EXPECT_NEAR(soft_energy({term}, at), 10 * 1e-4 * 4e-6 / (0.085 * 0.085), 1e-15);
}

TEST(FitTerm, LetsGoWithItsRelease) {
  const StyleWeights weights = style_weights(1.7);
  EXPECT_EQ(fit_term(0, skin, 5e-3, 0, 1e-4, weights).weight, 0);
  EXPECT_NEAR(fit_term(0, skin, 5e-3, 0.5, 1e-4, weights).weight * 2, fit_term(0, skin, 5e-3, 1, 1e-4, weights).weight, 1e-15);
}

TEST(ProportionTerm, SeesOnlyTheAxis) {
  const SoftTerm term = proportion_term(0, -Eigen::Vector3d::UnitY(), -0.8, 1e-4, style_weights(1.7));
  Eigen::Matrix3Xd at(3, 1);
  at.col(0) = Eigen::Vector3d(3, 0.8, -2);
  EXPECT_NEAR(soft_energy({term}, at), 0, 1e-18);
  at(1, 0) = 0.81;
  EXPECT_GT(soft_energy({term}, at), 0);
}

TEST(Smoothstep, RisesFromZeroToOneWithoutACorner) {
  EXPECT_EQ(smoothstep(0.1, 0.1, 0.3), 0);
  EXPECT_NEAR(smoothstep(0.2, 0.1, 0.3), 0.5, 1e-15);
  EXPECT_EQ(smoothstep(0.4, 0.1, 0.3), 1);
  EXPECT_LT(smoothstep(0.1 + 1e-6, 0.1, 0.3), 1e-9);
  EXPECT_EQ(smoothstep(0.2, 0.2, 0.2), 1);
}

TEST(HardConstraints, LeaveAVertexFreeAcrossTheAxisOnly) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 2).normalized();
  HardConstraints hard;
  hard.hold_along(3, axis, 0.7);
  const VertexFreedom& freedom = hard.vertices.at(3);
  ASSERT_EQ(freedom.free.cols(), 2);
  const Eigen::Matrix3Xd across = freedom.free;
  EXPECT_NEAR(axis.dot(freedom.fixed), 0.7, 1e-15);
  EXPECT_LT(Eigen::RowVectorXd(axis.transpose() * across).norm(), 1e-15);
  EXPECT_LT(Eigen::MatrixXd(across.transpose() * across - Eigen::MatrixXd::Identity(2, 2)).norm(), 1e-14);
  hard.hold(3, {1, 2, 3});
  EXPECT_EQ(hard.vertices.at(3).free.cols(), 0);
}

}  // namespace
}  // namespace toile
