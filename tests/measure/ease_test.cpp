#include "measure/ease.h"

#include <gtest/gtest.h>

#include "measure/worn_tube.h"

namespace toile {
namespace {

// From the skin to where the distance field ends and far beyond, inside and outside.
TEST(Ease, RoundARoundBodyIsTheDifferenceOfTheRadii) {
  const Body body = test::round_body(.12);
  const GarmentMesh garment = test::tube_of_cloth(.12, .4, 90, 10);
  const double facets = .12 * (1 - std::cos(test::pi / 180));  // 0.02 mm: what the corners of the body stand out
  for (const double air : {-.004, 0., .001, .01, .03, .05, .12, .4}) {
    const Eigen::VectorXd ease = air_to_body(test::worn_round(garment, .12 + air, .6), body);
    EXPECT_NEAR(ease.minCoeff(), air, facets + 3e-5) << air;
    EXPECT_NEAR(ease.maxCoeff(), air, facets + 3e-5) << air;
  }
}

}  // namespace
}  // namespace toile
