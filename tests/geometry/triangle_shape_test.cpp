#include "geometry/triangle_shape.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

namespace toile {
namespace {

const Eigen::Vector3d a(.1, .2, .3), b(.5, .1, .2), c(.2, .6, .1);

TEST(TriangleShape, KeepsTheThreeSideLengths) {
  const Eigen::Matrix2d shape = triangle_shape(a, b, c);
  EXPECT_NEAR(shape.col(0).norm(), (b - a).norm(), 1e-15);
  EXPECT_NEAR(shape.col(1).norm(), (c - a).norm(), 1e-15);
  EXPECT_NEAR((shape.col(1) - shape.col(0)).norm(), (c - b).norm(), 1e-15);
}

TEST(StretchAgreement, IsOneForCongruentTriangles) {
  const Eigen::Matrix2d shape = triangle_shape(a, b, c);
  EXPECT_NEAR(stretch_agreement(shape, shape), 1, 1e-12);
}

// The printed eigenvalues would differ here by more than 1e-3.
TEST(StretchAgreement, DoesNotDependOnTheFirstCorner) {
  Eigen::Matrix3d stretch = Eigen::Matrix3d::Identity();
  stretch << 1.1, .3, 0, 0, .95, 0, 0, 0, 1;
  const auto agreement = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
    return stretch_agreement(triangle_shape(p, q, r), triangle_shape(stretch * p, stretch * q, stretch * r));
  };
  EXPECT_NEAR(agreement(a, b, c), agreement(b, c, a), 1e-12);
  EXPECT_NEAR(agreement(a, b, c), agreement(c, a, b), 1e-12);
}

TEST(PrintedAgreement, SeesTheEdgeAndTheHeightAndNoShear) {
  Eigen::Matrix2d draped, goal;
  draped << 1, .3, 0, .8;
  goal << 1.1, .5, 0, .72;
  EXPECT_NEAR(printed_agreement(draped, goal), 1 - std::hypot(.1, .1), 1e-15);
  goal << 1, .6, 0, .8;
  EXPECT_EQ(printed_agreement(draped, goal), 1);
  EXPECT_LT(stretch_agreement(draped, goal), .8);
}

TEST(NextRest, UndoesAFixedStretchInOneStep) {
  Eigen::Matrix2d map;
  map << 1.1, .05, -.02, 1.03;
  const Eigen::Matrix2d rest = triangle_shape(a, b, c);
  Eigen::Matrix2d goal;
  goal << .4, .2, 0, .3;
  EXPECT_TRUE((map * next_rest(rest, map * rest, goal)).isApprox(goal, 1e-12));
}

}  // namespace
}  // namespace toile
