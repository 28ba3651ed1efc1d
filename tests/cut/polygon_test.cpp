#include "cut/polygon.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

TEST(Polygon, KnowsItsAreaAndWhatItContains) {
  EXPECT_DOUBLE_EQ(signed_area(square), 1);
  EXPECT_TRUE(contains(square, {0.5, 0.99}));
  EXPECT_FALSE(contains(square, {0.5, 1.01}));
  EXPECT_FALSE(contains(square, {-0.1, 0.5}));
}

TEST(Polygon, OverlapsWhereItReaches) {
  const auto moved = [](double x, double y) {
    Polygon polygon = square;
    for (Eigen::Vector2d& p : polygon) p += Eigen::Vector2d(x, y);
    return polygon;
  };
  EXPECT_TRUE(overlap(square, moved(0.5, 0.5)));
  EXPECT_TRUE(overlap(square, {{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}));  // within
  EXPECT_TRUE(overlap({{0.4, 0.4}, {0.6, 0.4}, {0.5, 0.6}}, square));
  EXPECT_FALSE(overlap(square, moved(1.001, 0)));
  EXPECT_FALSE(overlap({{0, 0}, {1, 0}, {0, 1}}, {{1, 1}, {0.1, 1}, {1, 0.1}}));  // boxes do, triangles do not
}

}  // namespace
}  // namespace toile
