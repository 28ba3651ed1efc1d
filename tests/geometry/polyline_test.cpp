#include "geometry/polyline.h"

#include <gtest/gtest.h>

namespace toile {
namespace {

const Points<2> corner{{0, 0}, {1, 0}, {1, 3}};

TEST(Polyline, FindsPointsByArcLength) {
  EXPECT_DOUBLE_EQ(polyline_length<2>(corner), 4);
  EXPECT_TRUE(point_at<2>(corner, .25).isApprox(Eigen::Vector2d(1, 0)));
  EXPECT_TRUE(point_at<2>(corner, .5).isApprox(Eigen::Vector2d(1, 1)));
  EXPECT_TRUE(direction_at<2>(corner, .25).isApprox(Eigen::Vector2d(0, 1)));
}

TEST(Polyline, NearestPointComesBackAsItsFraction) {
  const PolylinePlace place = nearest_on<2>(corner, {1.5, 1});
  EXPECT_NEAR(place.at, .5, 1e-15);
  EXPECT_NEAR(place.distance, .5, 1e-15);
}

TEST(Polyline, PartIsReversedWhenBeginIsBehindEnd) {
  const Points<2> part = part_of<2>(corner, .5, 0);
  ASSERT_EQ(part.size(), 3u);
  EXPECT_TRUE(part.front().isApprox(Eigen::Vector2d(1, 1)));
  EXPECT_NEAR(polyline_length<2>(part), 2, 1e-15);
}

TEST(Polyline, ResamplingKeepsTheEnds) {
  const Points<2> samples = resample<2>(corner, 8);
  ASSERT_EQ(samples.size(), 9u);
  EXPECT_EQ(samples.front(), corner.front());
  EXPECT_EQ(samples.back(), corner.back());
}

}  // namespace
}  // namespace toile
