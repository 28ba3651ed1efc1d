#include "collide/intersections.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "sheets.h"

namespace toile::test {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Sheet two_triangles(std::initializer_list<Eigen::Vector3d> corners, std::array<int, 6> list) {
  Sheet made{Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(corners.size())), Eigen::Matrix3Xi(3, 2)};
  Eigen::Index v = 0;
  for (const Eigen::Vector3d& corner : corners) made.positions.col(v++) = corner;
  for (int i = 0; i < 6; ++i) made.triangles(i % 3, i / 3) = list[static_cast<std::size_t>(i)];
  return made;
}

Pairs found(const Sheet& s) { return intersecting_triangles(s.positions, s.triangles); }

TEST(Intersections, AFlatSheetHasNone) { EXPECT_TRUE(found(sheet(8, .1, 0)).empty()); }

TEST(Intersections, PiercingTrianglesAreNamed) {
  const Sheet piercing =
      two_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.2, .2, -1}, {.3, .2, 1}, {.2, .3, 1}}, {0, 1, 2, 3, 4, 5});
  EXPECT_EQ(found(piercing), (Pairs{{0, 1}}));
}

TEST(Intersections, TrianglesWithACommonCornerCountOnlyWhenTheyMeetElsewhere) {
  EXPECT_TRUE(found(two_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, .5}, {0, -1, .5}}, {0, 1, 2, 0, 3, 4})).empty());
  EXPECT_EQ(found(two_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.4, .4, -.5}, {.4, .4, .5}}, {0, 1, 2, 0, 3, 4})),
            (Pairs{{0, 1}}));
}

TEST(Intersections, NeighboursAcrossAnEdgeDoNotCount) {
  EXPECT_TRUE(found(two_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}}, {0, 1, 2, 1, 0, 3})).empty());
}

TEST(Intersections, AHairsBreadthDecides) {
  const double hair = 1e-15;
  const auto over = [](double height) {
    return two_triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {.2, .2, height}, {.3, .2, 1}, {.2, .3, 1}}, {0, 1, 2, 3, 4, 5});
  };
  EXPECT_TRUE(found(over(hair)).empty());
  EXPECT_EQ(found(over(-hair)).size(), 1u);
}

TEST(Intersections, AgreeWithEdgesThroughTriangles) {
  const Sheet cloud = scattered(150, .25, 9);
  Pairs expected;
  const auto pierces = [&](int t, int other) {
    const Eigen::Matrix3d c = cloud.positions(Eigen::all, cloud.triangles.col(other));
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d from = cloud.positions.col(cloud.triangles(i, t));
      const Eigen::Vector3d to = cloud.positions.col(cloud.triangles((i + 1) % 3, t));
      Eigen::Matrix3d m;
      m << c.col(1) - c.col(0), c.col(2) - c.col(0), from - to;
      const Eigen::Vector3d at = m.inverse() * (from - c.col(0));
      if (at(0) > 0 && at(1) > 0 && at(0) + at(1) < 1 && at(2) > 0 && at(2) < 1) return true;
    }
    return false;
  };
  for (int a = 0; a < 150; ++a)
    for (int b = a + 1; b < 150; ++b)
      if (pierces(a, b) || pierces(b, a)) expected.emplace_back(a, b);
  EXPECT_GT(expected.size(), 10u);
  EXPECT_EQ(found(cloud), expected);
}

// Two sheets that come together, pass through each other and part again, in steps small and large.
TEST(IntersectionSearch, SaysTheSameAsAFreshLookWhileASheetMoves) {
  const Sheet lower = sheet(6, .02, 0), upper = sheet(6, .02, 0);
  const Eigen::Index n = lower.positions.cols();
  Sheet pair = both(lower, upper);
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(.05, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  IntersectionSearch search(pair.triangles, 3e-3);
  int passing = 0;
  for (int step = 0; step <= 60; ++step) {
    const double height = step < 20 ? .02 - .001 * step : step < 40 ? -.0002 * (step - 20) : -.02 + .01 * (step % 5);
    pair.positions.rightCols(n) = turned * upper.positions;
    pair.positions.rightCols(n).colwise() += Eigen::Vector3d(height / 3, height / 2, height);
    const bool fresh = !found(pair).empty();
    passing += fresh;
    EXPECT_EQ(search.any(pair.positions), fresh) << step;
  }
  EXPECT_GT(passing, 5);
  EXPECT_LT(passing, 55);
}

}  // namespace
}  // namespace toile::test
