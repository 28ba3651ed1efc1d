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

TEST(Polygon, DistanceBetweenSegments) {
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {0.5, 0.3}, {0.7, 1}), 0.3);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {0.5, -1}, {0.5, 1}), 0);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {4, 4}, {4, 5}), 5);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {0.2, 0.5}, {0.8, 0.5}), 0.5);
}

TEST(Polygon, FindsWhereItCrossesTouchesOrFoldsBack) {
  EXPECT_FALSE(first_self_crossing(square));
  EXPECT_TRUE(first_self_crossing({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));                  // bow
  EXPECT_TRUE(first_self_crossing({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));          // corner on an edge
  EXPECT_TRUE(first_self_crossing({{0, 0}, {1, 0}, {1, 1}, {1, 3}, {1, 1}, {0, 1}}));  // spike
  EXPECT_FALSE(first_self_crossing({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}));         // a point on a straight edge
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
