#include "measure/tailoring.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "measure/worn_tube.h"

namespace toile::test {
namespace {

const GarmentMesh tube = tube_of_cloth(.15, .5, 48, 20);
const Eigen::Matrix3Xd worn = worn_round(tube, .15, .5);

TEST(Tailoring, OfADrapeToItselfIsNothing) {
  const TailoringDifference same = tailoring_difference(tube, worn, worn);
  EXPECT_EQ(same, TailoringDifference{});
  EXPECT_TRUE(only_folds_differ(same));
}

TEST(Tailoring, SeesAWiderGarment) {
  const TailoringDifference wider = tailoring_difference(tube, worn, worn_round(tube, .153, .5));
  EXPECT_NEAR(wider.girth, .02, 1e-9);
  EXPECT_NEAR(wider.seam_length, 0, 1e-12);
  EXPECT_FALSE(only_folds_differ(wider));
}

TEST(Tailoring, SeesALongerSeamAndWhereTheHemHasGone) {
  const TailoringDifference longer = tailoring_difference(tube, worn, worn_round(tube, .15, .5, 1.02));
  EXPECT_NEAR(longer.girth, 0, 1e-9);
  EXPECT_NEAR(longer.seam_length, .01, 1e-9);
  EXPECT_NEAR(longer.level, .01, 1e-9);
  EXPECT_FALSE(only_folds_differ(longer));
}

// An ellipse of the same length of cloth, turned or not, is the same garment in other folds.
TEST(Tailoring, DoesNotSeeOtherFolds) {
  const auto folded = [](double turn) {
    Eigen::Matrix3Xd x = worn;
    x.row(0) *= 1.2;
    x.row(2) *= .75;
    const Eigen::Matrix3d about = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitY()).toRotationMatrix();
    return Eigen::Matrix3Xd(about * x);
  };
  const TailoringDifference turned = tailoring_difference(tube, folded(0), folded(.8));
  EXPECT_GT((folded(0) - folded(.8)).colwise().norm().maxCoeff(), .05);
  EXPECT_NEAR(turned.girth, 0, 1e-9);
  EXPECT_NEAR(turned.seam_length, 0, 1e-9);
  EXPECT_TRUE(only_folds_differ(turned));
}

TEST(Tailoring, RefusesDrapesOfAnotherGarment) {
  EXPECT_THROW(tailoring_difference(tube, worn, worn.leftCols(5)), std::invalid_argument);
}

}  // namespace
}  // namespace toile::test
