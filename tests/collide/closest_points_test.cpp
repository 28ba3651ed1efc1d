#include "collide/closest_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

Vec random_point(std::mt19937& random) {
  std::uniform_real_distribution<double> in(-1, 1);
  const double x = in(random), y = in(random);
  return {x, y, in(random)};
}

TEST(ClosestPoints, PointOverATriangleIsItsHeightAway) {
  const auto closest = closest_to_triangle({.25, .25, .3}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_DOUBLE_EQ(closest.distance, .3);
  EXPECT_NEAR((closest.weight - Eigen::Vector4d(1, .5, .25, .25)).norm(), 0, 1e-15);
  EXPECT_NEAR((closest.apart - Vec(0, 0, .3)).norm(), 0, 1e-15);
}

TEST(ClosestPoints, PointBeyondACornerAndBesideAnEdge) {
  EXPECT_DOUBLE_EQ(closest_to_triangle({-3, -4, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}).distance, 5);
  const auto beside = closest_to_triangle({.5, -2, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_DOUBLE_EQ(beside.distance, 2);
  EXPECT_NEAR((beside.weight - Eigen::Vector4d(1, .5, .5, 0)).norm(), 0, 1e-15);
}

TEST(ClosestPoints, ATriangleWithoutAreaCountsAsItsEdges) {
  EXPECT_DOUBLE_EQ(closest_to_triangle({.5, 1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}).distance, 1);
  EXPECT_DOUBLE_EQ(closest_to_triangle({3, 4, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}).distance, 5);
}

TEST(ClosestPoints, CrossingAndParallelSegments) {
  const auto crossing = closest_of_segments({-1, 0, .2}, {1, 0, .2}, {0, -1, 0}, {0, 3, 0});
  EXPECT_DOUBLE_EQ(crossing.distance, .2);
  EXPECT_NEAR((crossing.weight - Eigen::Vector4d(.5, .5, .75, .25)).norm(), 0, 1e-15);
  EXPECT_DOUBLE_EQ(closest_of_segments({0, 0, 0}, {1, 0, 0}, {.2, .5, 0}, {3, .5, 0}).distance, .5);
  EXPECT_DOUBLE_EQ(closest_of_segments({0, 0, 0}, {1, 0, 0}, {4, 4, 0}, {5, 4, 0}).distance, 5);
  EXPECT_DOUBLE_EQ(closest_of_segments({0, 0, 0}, {0, 0, 0}, {4, 3, 0}, {4, 3, 0}).distance, 5);
}

// No point of a fine sampling is nearer, and the weights give the points that the distance is between.
TEST(ClosestPoints, NothingSampledIsNearer) {
  std::mt19937 random(5);
  constexpr int n = 40;
  for (int trial = 0; trial < 200; ++trial) {
    const Vec a = random_point(random), b = random_point(random), c = random_point(random), d = random_point(random);
    const auto triangle = closest_to_triangle(a, b, c, d);
    const auto segments = closest_of_segments(a, b, c, d);
    EXPECT_GE(std::min(triangle.weight.minCoeff(), segments.weight.minCoeff()), 0);
    EXPECT_NEAR((a - triangle.weight(1) * b - triangle.weight(2) * c - triangle.weight(3) * d - triangle.apart).norm(), 0,
                1e-12);
    const Vec between = segments.weight(0) * a + segments.weight(1) * b - segments.weight(2) * c - segments.weight(3) * d;
    EXPECT_NEAR((between - segments.apart).norm(), 0, 1e-12);
    EXPECT_NEAR(segments.distance, between.norm(), 1e-12);
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const double s = double(i) / n, t = double(j) / n;
        EXPECT_GE((a + s * (b - a) - c - t * (d - c)).norm(), segments.distance - 1e-12);
        if (i + j <= n) {
          EXPECT_GE((a - b - s * (c - b) - t * (d - b)).norm(), triangle.distance - 1e-12);
        }
      }
  }
}

}  // namespace
}  // namespace toile
