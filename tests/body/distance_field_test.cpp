#include "body/distance_field.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <random>
#include <stdexcept>

#include "body/grid_winding.h"
#include "body/shapes.h"
#include "body/spline_grid.h"
#include "body/triangle_tree.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

class Points {
 public:
  explicit Points(unsigned seed) : engine_(seed) {}
  Vec in_box(double half) { return half * Vec(unit_(engine_), unit_(engine_), unit_(engine_)); }
  Vec direction() {
    for (;;)
      if (const Vec v = in_box(1); v.norm() < 1 && v.norm() > .1) return v.normalized();
  }
  double between(double low, double high) { return low + (high - low) * (unit_(engine_) + 1) / 2; }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> unit_{-1, 1};
};

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

TEST(GridWinding, CountsNodesOnFacesEdgesAndCornersOnce) {
  // The box's faces, edges and corners all fall on nodes, the hardest case for a ray.
  const auto shape = test::box({.5, .5, .5}, {.25, .25, .25});
  GridFrame grid{Vec::Zero(), .125, {9, 9, 9}};
  const auto winding = winding_on_grid(grid, shape.positions, shape.triangles);
  int inside = 0;
  for (int k = 0; k < 9; ++k)
    for (int j = 0; j < 9; ++j)
      for (int i = 0; i < 9; ++i) {
        const int found = winding[grid.index(i, j, k)];
        const double away = (grid.at(i, j, k) - Vec::Constant(.5)).cwiseAbs().maxCoeff();
        if (away != .25) {
          EXPECT_EQ(found, away < .25 ? 1 : 0);
        }
        inside += found;
      }
  EXPECT_EQ(inside, 4 * 4 * 4);  // each face belongs to one side only
}

TEST(SplineGrid, TakesTheSamplesAtTheNodes) {
  GridFrame grid{{.1, -.2, .3}, .05, {7, 9, 8}};
  Points points(11);
  std::vector<float> samples(grid.nodes());
  for (float& sample : samples) sample = static_cast<float>(points.between(-1, 1));
  const SplineGrid spline(grid, samples, 2);
  for (int k = 1; k < grid.size[2] - 1; ++k)
    for (int j = 1; j < grid.size[1] - 1; ++j)
      for (int i = 1; i < grid.size[0] - 1; ++i)
        EXPECT_NEAR(spline.value(grid.at(i, j, k)), samples[grid.index(i, j, k)], 2e-6);
}

TEST(SplineGrid, ReproducesALinearFunctionAwayFromTheEnds) {
  GridFrame grid{Vec::Zero(), .05, {40, 40, 40}};
  const Vec slope(.3, -.7, .5);
  std::vector<float> samples(grid.nodes());
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i) samples[grid.index(i, j, k)] = static_cast<float>(slope.dot(grid.at(i, j, k)));
  const SplineGrid spline(grid, samples, 1);
  const SplineSample found = spline.sample({1.013, .977, 1.031});
  EXPECT_NEAR(found.value, slope.dot(Vec(1.013, .977, 1.031)), 1e-6);
  EXPECT_LT((found.gradient - slope).norm(), 2e-5);
  EXPECT_LT(found.hessian.norm(), 1e-3);
}

TEST(TriangleTree, FindsWhatTryingEveryTriangleFinds) {
  Points points(12);
  Eigen::Matrix3Xd corners(3, 150);
  Eigen::Matrix3Xi triangles(3, 50);
  for (int t = 0; t < 50; ++t) {
    const Vec middle = points.in_box(1);
    for (int c = 0; c < 3; ++c) {
      corners.col(3 * t + c) = middle + points.in_box(.3);
      triangles(c, t) = 3 * t + c;
    }
  }
  const TriangleTree tree(corners, triangles);
  for (int q = 0; q < 200; ++q) {
    const Vec query = points.in_box(1.5);
    double best = 1e9;
    for (int t = 0; t < 50; ++t) {
      const TriangleTree one(corners.middleCols(3 * t, 3), Eigen::Matrix3Xi(triangles.col(0)));
      best = std::min(best, one.nearest(query).distance);
    }
    const NearestPoint found = tree.nearest(query, 10, q % 50);
    EXPECT_DOUBLE_EQ(found.distance, best);
    EXPECT_NEAR((found.at - query).norm(), best, 1e-15);
    EXPECT_EQ(tree.nearest(query, best * .99).triangle, -1);
  }
}

TEST(TriangleTree, NearestPointOfATriangleBeatsEveryPointOfIt) {
  Points points(13);
  for (int t = 0; t < 50; ++t) {
    Eigen::Matrix3Xd corners(3, 3);
    for (int c = 0; c < 3; ++c) corners.col(c) = points.in_box(1);
    const TriangleTree tree(corners, Eigen::Matrix3Xi(Eigen::Vector3i(0, 1, 2)));
    const Vec query = points.in_box(2);
    const NearestPoint found = tree.nearest(query);
    const Vec weights = (Eigen::Matrix3d() << corners).finished().colPivHouseholderQr().solve(found.at);
    EXPECT_GE(weights.minCoeff(), -1e-9);
    EXPECT_NEAR(weights.sum(), 1, 1e-9);
    double best = 1e9;
    for (int i = 0; i <= 60; ++i)
      for (int j = 0; i + j <= 60; ++j) best = std::min(best, (corners * Vec(i, j, 60 - i - j) / 60 - query).norm());
    EXPECT_LE(found.distance, best + 1e-12);
    EXPECT_GT(found.distance, best - .05);
  }
}

TEST(TriangleTree, SeesEveryWallARayCrosses) {
  const auto shape = test::both(test::box({0, 0, 0}, {.1, .1, .1}), test::box({.5, 0, 0}, {.1, .1, .1}));
  const TriangleTree tree(shape.positions, shape.triangles);
  const auto found = tree.crossings({-1, .03, .02}, {1, 0, 0}, 3);
  ASSERT_EQ(found.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(found[i], (std::array{.9, 1.1, 1.4, 1.6})[i], 1e-12);
  EXPECT_EQ(tree.pierced({.03, .02, 0}, {.2, .02, 0}).size(), 1u);
}

}  // namespace
}  // namespace toile
