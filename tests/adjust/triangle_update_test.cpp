#include "adjust/triangle_update.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "geometry/triangle_shape.h"

namespace toile {
namespace {

Eigen::Matrix2d matrix(double a, double b, double c, double d) {
  Eigen::Matrix2d m;
  m << a, b, c, d;
  return m;
}

const Eigen::Matrix2d rest = matrix(.02, .007, 0, .018), stretch = matrix(1.08, .03, .03, .96),
                      edit = matrix(1.2, -.05, -.05, 1.1);

// The shape with the triangle's second corner first.
Eigen::Matrix2d from_next_corner(const Eigen::Matrix2d& shape) {
  Eigen::Matrix2d next;
  next << shape.col(1) - shape.col(0), -shape.col(0);
  return next;
}

bool congruent(const Eigen::Matrix2d& a, const Eigen::Matrix2d& b) {
  return triangle_shape(a).isApprox(triangle_shape(b), 1e-10);
}

TEST(UpdatedRest, ReachesTheGoalUnderAFixedStretch) {
  const Eigen::Matrix2d goal = edit * stretch * rest;
  const Eigen::Matrix2d next = updated_rest(rest, stretch * rest, goal);
  EXPECT_TRUE(congruent(stretch * next, goal));
}

TEST(UpdatedRest, DoesNotDependOnCornersOrTurns) {
  const Eigen::Matrix2d drape = stretch * rest, goal = edit * drape;
  const Eigen::Matrix2d next = updated_rest(rest, drape, goal, .6);
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(1.1).toRotationMatrix();
  EXPECT_TRUE(congruent(next, updated_rest(rest, drape, turn * goal, .6)));
  // As the shapes come, each on its own x axis.
  const auto laid = [](const Eigen::Matrix2d& shape) { return triangle_shape(shape); };
  const Eigen::Matrix2d other =
      updated_rest(laid(from_next_corner(rest)), laid(from_next_corner(drape)), laid(from_next_corner(goal)), .6);
  EXPECT_TRUE(congruent(from_next_corner(updated_rest(laid(rest), laid(drape), laid(goal), .6)), other));
}

TEST(UpdatedRest, GainZeroStaysAndGainOneIsReachedInHalves) {
  const Eigen::Matrix2d drape = stretch * rest, goal = edit * drape;
  EXPECT_TRUE(updated_rest(rest, drape, goal, 0).isApprox(rest, 1e-12));
  const Eigen::Matrix2d half = updated_rest(rest, drape, goal, .5);
  EXPECT_TRUE(congruent(updated_rest(half, stretch * half, goal, 1), updated_rest(rest, drape, goal, 1)));
}

TEST(UpdatedRest, KeepsTheRestShapeOfACollapsedTriangle) {
  const Eigen::Matrix2d flat = matrix(.02, .01, 0, 0);
  EXPECT_EQ(updated_rest(rest, flat, rest), rest);
  EXPECT_EQ(updated_rest(rest, rest, flat), rest);
}

TEST(WithoutCompression, StretchesBackOnlyWhatWasCompressed) {  // Eq. 9
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(.4).toRotationMatrix();
  const Eigen::Matrix2d draping = turn * matrix(1.1, 0, 0, .9) * turn.transpose();
  const Eigen::Matrix2d source = draping * rest;
  const Eigen::Matrix2d undone = without_compression(source, rest, source);
  const Eigen::Matrix2d wanted = turn * matrix(1.1, 0, 0, 1) * turn.transpose() * rest;
  EXPECT_TRUE(congruent(undone, wanted));
  EXPECT_TRUE(congruent(without_compression(edit * rest, rest, 1.2 * rest), edit * rest));
}

}  // namespace
}  // namespace toile
