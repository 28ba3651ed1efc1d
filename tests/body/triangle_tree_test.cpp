#include "body/triangle_tree.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <array>

#include "body/points.h"
#include "body/shapes.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

TEST(TriangleTree, FindsWhatTryingEveryTriangleFinds) {
  test::Points points(12);
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
  test::Points points(13);
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
