#include "body/distance_field.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "body/points.h"
#include "body/shapes.h"

namespace toile {
namespace {

using test::Points;
using Vec = Eigen::Vector3d;

double box_distance(const Vec& half, const Vec& at) {
  const Vec q = at.cwiseAbs() - half;
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0);
}

const Vec centre(.013, .207, -.031);
constexpr double radius = .15;

const DistanceField& ball() {
  static const DistanceField field = [] {
    const auto shape = test::sphere(centre, radius, 5);
    return DistanceField(shape.positions, shape.triangles);
  }();
  return field;
}

TEST(DistanceField, IsRadiusOffTheCentreForASphere) {
  Points points(1);
  for (int i = 0; i < 2000; ++i) {
    const Vec out = points.direction();
    const double wanted = points.between(-.04, .04);
    const DistanceSample found = ball().sample(centre + (radius + wanted) * out);
    EXPECT_NEAR(found.distance, wanted, 2e-4);       // the facets lie up to 0.1 mm inside the sphere
    EXPECT_LT((found.gradient - out).norm(), 5e-2);  // neighbouring facets turn by 0.05
  }
}

TEST(DistanceField, CurvesAsTheSphereDoes) {
  Points points(2);
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 4000; ++i) {
    const Vec out = points.direction();
    const Eigen::Matrix3d frame = Eigen::Quaterniond::FromTwoVectors(out, Vec::UnitZ()).toRotationMatrix();
    mean += frame * ball().sample(centre + (radius + .02) * out).hessian * frame.transpose() / 4000;
  }
  EXPECT_NEAR(mean(0, 0), 1 / (radius + .02), .2);
  EXPECT_NEAR(mean(1, 1), 1 / (radius + .02), .2);
  EXPECT_NEAR(mean(2, 2), 0, .2);
}

TEST(DistanceField, KnowsEveryPointsSideOfABox) {
  const Vec half(.11, .23, .07);
  const auto shape = test::box(Vec::Zero(), half);
  const DistanceField field(shape.positions, shape.triangles);
  Points points(3);
  for (int i = 0; i < 5000; ++i) {
    const Vec at = points.in_box(.5);
    const double exact = box_distance(half, at);
    if (std::abs(exact) < 1e-3) continue;
    EXPECT_EQ(field.distance(at) > 0, exact > 0) << at.transpose();
  }
}

TEST(DistanceField, IsExactBesideTheFacesOfABox) {
  const Vec half(.11, .23, .07);
  const auto shape = test::box(Vec::Zero(), half);
  const DistanceField field(shape.positions, shape.triangles);
  Points points(4);
  for (int i = 0; i < 2000; ++i) {
    Vec at = points.in_box(.03);  // middle of a face, so the crease of the interior's medial axis is far
    at[2] = half[2] + points.between(-.02, .04);
    EXPECT_NEAR(field.distance(at), at[2] - half[2], 1e-6);
    EXPECT_LT((field.sample(at).gradient - Vec::UnitZ()).norm(), 1e-4);
  }
}

TEST(DistanceField, DerivativesAreThoseOfItsOwnValue) {
  Points points(5);
  const double step = 1e-5;
  for (int i = 0; i < 300; ++i) {
    const Vec at = centre + (radius + points.between(-.06, .06)) * points.direction();
    const DistanceSample here = ball().sample(at);
    EXPECT_DOUBLE_EQ(here.distance, ball().distance(at));
    for (int axis = 0; axis < 3; ++axis) {
      const Vec h = step * Vec::Unit(axis);
      const double slope = (ball().distance(at + h) - ball().distance(at - h)) / (2 * step);
      EXPECT_NEAR(here.gradient[axis], slope, 1e-6);
      const Vec bend = (ball().sample(at + h).gradient - ball().sample(at - h).gradient) / (2 * step);
      EXPECT_LT((here.hessian.col(axis) - bend).norm(), 1e-6 / step);
    }
  }
}

TEST(DistanceField, StaysC2AcrossCells) {
  // On both sides of the planes between cells value, gradient and Hessian agree to first order in the gap.
  const double gap = 1e-9, cell = 6e-3;
  Points points(6);
  for (int i = 0; i < 200; ++i) {
    Vec at = centre + (radius + points.between(-.03, .03)) * points.direction();
    const Vec low = centre.array() - radius - .04 - 6 * cell;
    const int axis = i % 3;
    at[axis] = low[axis] + cell * std::round((at[axis] - low[axis]) / cell);
    const DistanceSample left = ball().sample(at - gap * Vec::Unit(axis)), right = ball().sample(at + gap * Vec::Unit(axis));
    EXPECT_NEAR(left.distance, right.distance, 4 * gap);
    EXPECT_LT((left.gradient - right.gradient).norm(), 1e-6);
    EXPECT_LT((left.hessian - right.hessian).norm(), 1e-3);
  }
}

TEST(DistanceField, GrowsOutwardsFarBeyondTheBandAndTheGrid) {
  Points points(7);
  for (int i = 0; i < 200; ++i) {
    const Vec out = points.direction();
    double before = 0;
    for (double away = .005; away < 3; away *= 1.07) {
      const double now = ball().distance(centre + (radius + away) * out);
      EXPECT_GT(now, before);
      EXPECT_NEAR(now, away, away < ball().band() ? 2e-4 : .25 * away);
      before = now;
    }
  }
}

TEST(DistanceField, SinksInwardsToTheCentre) {
  Points points(8);
  for (int i = 0; i < 100; ++i) {
    const Vec out = points.direction();
    double before = 0;
    for (double deep = .004; deep < radius - .03; deep += .004) {
      const double now = ball().distance(centre + (radius - deep) * out);
      EXPECT_LT(now, before);
      EXPECT_NEAR(now, -deep, deep < ball().band() ? 2e-4 : .05 * deep);
      before = now;
    }
  }
}

TEST(DistanceField, DerivativesBeyondTheGridAreThoseOfItsValue) {
  Points points(9);
  const double step = 1e-5;
  for (int i = 0; i < 100; ++i) {
    const Vec at = centre + points.between(.5, 1) * points.direction();
    const DistanceSample here = ball().sample(at);
    for (int axis = 0; axis < 3; ++axis) {
      const Vec h = step * Vec::Unit(axis);
      EXPECT_NEAR(here.gradient[axis], (ball().distance(at + h) - ball().distance(at - h)) / (2 * step), 1e-6);
      const Vec bend = (ball().sample(at + h).gradient - ball().sample(at - h).gradient) / (2 * step);
      EXPECT_LT((here.hessian.col(axis) - bend).norm(), .1);
    }
  }
}

TEST(DistanceField, CountsAnOverlapAsInside) {
  const auto shape = test::both(test::box({0, 0, 0}, {.1, .1, .1}), test::box({.1, .05, 0}, {.1, .1, .1}));
  const DistanceField field(shape.positions, shape.triangles);
  EXPECT_LT(field.distance({.05, .02, 0}), 0);
  EXPECT_LT(field.distance({-.05, 0, 0}), 0);
  EXPECT_LT(field.distance({.15, .05, 0}), 0);
  EXPECT_GT(field.distance({-.05, .12, 0}), 0);
}

TEST(DistanceField, GivesTheSameBytesTwice) {
  const auto shape = test::sphere(centre, radius, 4);
  const DistanceField once(shape.positions, shape.triangles), twice(shape.positions, shape.triangles);
  Points points(10);
  for (int i = 0; i < 1000; ++i) {
    const Vec at = centre + points.in_box(.4);
    EXPECT_EQ(once.distance(at), twice.distance(at));
  }
}

TEST(DistanceField, RefusesWhatIsNoClosedOutwardSurface) {
  const auto shape = test::sphere(centre, radius, 2);
  const auto open = test::without_triangle(shape, 5);
  EXPECT_THROW(DistanceField(open.positions, open.triangles), std::invalid_argument);
  const auto inwards = test::turned_over(shape);
  EXPECT_THROW(DistanceField(inwards.positions, inwards.triangles), std::invalid_argument);
  auto broken = shape;
  broken.positions(1, 3) = std::nan("");
  EXPECT_THROW(DistanceField(broken.positions, broken.triangles), std::invalid_argument);
  EXPECT_THROW(DistanceField(shape.positions, shape.triangles, 1e-6), std::invalid_argument);
  EXPECT_THROW(DistanceField().distance(centre), std::invalid_argument);
}

}  // namespace
}  // namespace toile
