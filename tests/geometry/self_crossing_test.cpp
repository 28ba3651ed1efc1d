#include "geometry/self_crossing.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "geometry/plane_segments.h"

namespace toile {
namespace {

using Loop = std::vector<Eigen::Vector2d>;

TEST(PlaneSegments, DistanceBetweenSegments) {
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {0.5, 0.3}, {0.7, 1}), 0.3);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {0.5, -1}, {0.5, 1}), 0);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {4, 4}, {4, 5}), 5);
  EXPECT_DOUBLE_EQ(distance({0, 0}, {1, 0}, {0.2, 0.5}, {0.8, 0.5}), 0.5);
}

TEST(SelfCrossing, FindsTheTwoSidesOfABowTie) {
  const auto crossing = first_self_crossing({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  ASSERT_TRUE(crossing);
  EXPECT_EQ(crossing->first, 0);
  EXPECT_EQ(crossing->second, 2);
}

TEST(SelfCrossing, LetsNeighboursMeetAndNothingElseTouch) {
  EXPECT_FALSE(first_self_crossing({{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_FALSE(first_self_crossing({{0, 0}, {2, 0}, {2, 2}, {1, 1e-9}, {0, 2}}));
  EXPECT_TRUE(first_self_crossing({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));  // a corner on the opposite side
}

TEST(SelfCrossing, SeesAnOutlineThatFoldsBackOntoItself) { EXPECT_TRUE(first_self_crossing({{0, 0}, {2, 0}, {1, 0}, {1, 1}})); }

// Against the quadratic definition with floating point, on polygons in general position.
TEST(SelfCrossing, AgreesWithTestingAllPairs) {
  const auto left_of = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0;
  };
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0, 1);
  int simple = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Loop loop;
    for (int i = 0; i < 6; ++i) loop.emplace_back(coordinate(random), coordinate(random));
    bool crosses = false;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = i + 2; j < 6; ++j) {
        if (i == 0 && j == 5) continue;
        const Eigen::Vector2d &a = loop[i], &b = loop[i + 1], &c = loop[j], &d = loop[(j + 1) % 6];
        crosses |= left_of(a, b, c) != left_of(a, b, d) && left_of(c, d, a) != left_of(c, d, b);
      }
    EXPECT_EQ(first_self_crossing(loop).has_value(), crosses);
    simple += !crosses;
  }
  EXPECT_GT(simple, 10);
}

TEST(SelfCrossing, ReportsTheFirstPairWhateverTheWayRound) {
  // Two bow ties in a row: sides 0 and 2, sides 4 and 6.
  const Loop loop{{0, 0}, {1, 1}, {1, 0}, {0, 1}, {0, 2}, {1, 3}, {1, 2}, {-1, 3}};
  const auto crossing = first_self_crossing(loop);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(*crossing, (SelfCrossing{0, 2}));
}

TEST(SelfCrossing, SidesAlmostTouchingCountWhenAsked) {
  const Loop notched{{0, 0}, {2, 0}, {2, 2}, {1, 1e-9}, {0, 2}};
  EXPECT_FALSE(first_self_crossing(notched));
  EXPECT_FALSE(first_self_crossing(notched, .9e-9));
  EXPECT_TRUE(first_self_crossing(notched, 1.1e-9));
  const Loop spike{{0, 0}, {1, 0}, {1, 1}, {1 + 1e-10, 3}, {1, 1}, {0, 1}};
  EXPECT_TRUE(first_self_crossing(spike, 1e-9));
  EXPECT_FALSE(first_self_crossing({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {0, 1}}, 1e-9));  // a point on a straight side
}

TEST(SelfCrossing, OfFewerThanThreeCornersIsCertain) {
  EXPECT_TRUE(first_self_crossing({}));
  EXPECT_TRUE(first_self_crossing({{0, 0}, {1, 0}}));
}

}  // namespace
}  // namespace toile
