#include "collide/truncation.h"

#include <gtest/gtest.h>

#include "collide/intersections.h"
#include "sheets.h"

namespace toile::test {
namespace {

TEST(Truncation, NothingInTheWayNothingClipped) {
  Sheet two = both(sheet(3, .02, 0), sheet(3, .02, .1));
  const Truncation truncation(two.positions, collision_mesh(two.triangles, 32), .008);
  Eigen::Matrix3Xd x = two.positions;
  Eigen::Matrix3Xd to = x;
  to.row(2).array() += .003;
  EXPECT_EQ(truncation.advance(x, to), 0);
  EXPECT_EQ(x, to);
}

TEST(Truncation, AMoveLongerThanTheSearchReachesIsShortened) {
  Sheet one = sheet(2, .02, 0);
  const Truncation truncation(one.positions, collision_mesh(one.triangles, 9), .008);
  Eigen::Matrix3Xd x = one.positions;
  Eigen::Matrix3Xd to = x;
  to.row(2).array() += 1;
  EXPECT_NEAR(truncation.advance(x, to), 1 - .45 * .008, 1e-12);
  EXPECT_NEAR(x.row(2).maxCoeff(), .45 * .008, 1e-12);
  EXPECT_GT(truncation.advance(x, to), .9) << "a second call has no more room";
  EXPECT_NEAR(x.row(2).maxCoeff(), .45 * .008, 1e-12);
}

TEST(Truncation, ASheetStopsAboveAnotherAndSlidesAlongIt) {
  Sheet two = both(sheet(8, .02, 0), sheet(2, .02, .004));
  two.positions.rightCols(9).topRows(2).array() += .051;
  const auto mesh = collision_mesh(two.triangles, static_cast<int>(two.positions.cols()));
  Eigen::Matrix3Xd x = two.positions;
  Eigen::Matrix3Xd to = x;
  to.rightCols(9).row(2).array() -= .0025;
  to.rightCols(9).row(0).array() += .002;
  EXPECT_NEAR(Truncation(x, mesh, .008).advance(x, to), .0007, 1e-12);
  for (Eigen::Index v = x.cols() - 9; v < x.cols(); ++v) {
    EXPECT_GE(x(2, v), .002) << "its side of the middle";
    EXPECT_LT(x(2, v), .0022 + 1e-12);
    EXPECT_NEAR(x(0, v), two.positions(0, v) + .002, 1e-12) << "along the plane it is free";
  }
}

// Whatever a solver asks for: random moves far larger than the gaps, many times over.
TEST(Truncation, AStartWithoutIntersectionsStaysSo) {
  Sheet heap = sheet(6, .02, 0);
  for (int layer = 1; layer < 5; ++layer) heap = both(heap, sheet(6, .02, .003 * layer));
  const auto mesh = collision_mesh(heap.triangles, static_cast<int>(heap.positions.cols()));
  ASSERT_TRUE(intersecting_triangles(heap.positions, heap.triangles).empty());
  std::mt19937 random(11);
  std::normal_distribution<double> push(0, .02);
  Eigen::Matrix3Xd x = heap.positions;
  double moved = 0;
  for (int step = 0; step < 60; ++step) {
    Eigen::Matrix3Xd to = x;
    for (Eigen::Index i = 0; i < to.size(); ++i) to(i) += push(random);
    const Eigen::Matrix3Xd before = x;
    const Truncation truncation(x, mesh, .008);
    truncation.advance(x, to);
    truncation.advance(x, before);  // and back on the same planes
    truncation.advance(x, to);
    moved += (x - before).colwise().norm().mean();
    ASSERT_TRUE(intersecting_triangles(x, heap.triangles).empty()) << step;
  }
  EXPECT_GT(moved, .01);
}

TEST(Truncation, TouchingClothDoesNotMoveThroughItself) {
  Sheet two = both(sheet(1, .02, 0), sheet(1, .02, 0));
  two.positions.rightCols(4).topRows(2).array() += .005;
  const Truncation truncation(two.positions, collision_mesh(two.triangles, 8), .008);
  Eigen::Matrix3Xd x = two.positions;
  Eigen::Matrix3Xd to = x;
  to.rightCols(4).row(2).array() -= .01;
  truncation.advance(x, to);
  for (const NearPair& pair : truncation.pairs())
    for (const int v : pair.vertex)
      if (pair.distance == 0) {
        EXPECT_EQ(x.col(v), two.positions.col(v));
      }
}

}  // namespace
}  // namespace toile::test
