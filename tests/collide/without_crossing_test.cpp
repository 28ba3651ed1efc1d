#include "collide/without_crossing.h"

#include <gtest/gtest.h>

#include "collide/intersections.h"
#include "sheets.h"

namespace toile::test {
namespace {

TEST(WithoutCrossing, ClothThatIsFreeArrives) {
  const Sheet one = sheet(4, .02, 0);
  Eigen::Matrix3Xd to = one.positions;
  to.row(2).array() += .2;
  to.row(0) *= 1.1;
  EXPECT_LT((without_crossing(one.positions, to, one.triangles) - to).norm(), 1e-5);
}

TEST(WithoutCrossing, ASheetSentThroughAnotherStaysOnItsSideAndSlides) {
  Sheet two = both(sheet(8, .02, 0), sheet(2, .02, .004));
  two.positions.rightCols(9).topRows(2).array() += .051;
  Eigen::Matrix3Xd to = two.positions;
  to.rightCols(9).row(2).array() -= .03;
  to.rightCols(9).row(0).array() += .04;
  ASSERT_FALSE(intersecting_triangles(two.positions, two.triangles).size());
  const Eigen::Matrix3Xd x = without_crossing(two.positions, to, two.triangles);
  EXPECT_TRUE(intersecting_triangles(x, two.triangles).empty());
  EXPECT_EQ(Eigen::Matrix3Xd(x.leftCols(81)), Eigen::Matrix3Xd(two.positions.leftCols(81)));
  for (Eigen::Index v = 81; v < x.cols(); ++v) {
    EXPECT_GT(x(2, v), 0);
    EXPECT_NEAR(x(0, v), to(0, v), 3e-3);
  }
}

}  // namespace
}  // namespace toile::test
