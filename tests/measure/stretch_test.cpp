#include "measure/stretch.h"

#include <gtest/gtest.h>

#include "measure/worn_tube.h"

namespace toile {
namespace {

using test::tube_of_cloth;
using test::worn_round;

TEST(GrainStretch, OfATubePulledWideAndLongIsExact) {
  const GarmentMesh garment = tube_of_cloth(.10, .4, 60, 20);
  const GrainStretch stretch = grain_stretch(garment, worn_round(garment, .108, .5, 1.03));
  ASSERT_EQ(stretch.warp.size(), triangle_count(garment));
  EXPECT_NEAR((stretch.warp.array() - .03).abs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR((stretch.weft.array() - .08).abs().maxCoeff(), 0, 1e-12);
  const double bias = std::sqrt((1.03 * 1.03 + 1.08 * 1.08) / 2) - 1;
  EXPECT_NEAR((stretch.bias.array() - bias).abs().maxCoeff(), 0, 1e-12);
}

TEST(GrainStretch, FollowsTheGrainAndNotThePanelsAxes) {
  GarmentMesh garment = tube_of_cloth(.10, .4, 60, 20);
  garment.panels[0].warp = Eigen::Vector2d::UnitX();
  const Eigen::Matrix3Xd worn = worn_round(garment, .108, .5, .97);
  const GrainStretch across = grain_stretch(garment, worn);
  EXPECT_NEAR((across.warp.array() - .08).abs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR((across.weft.array() + .03).abs().maxCoeff(), 0, 1e-12);
  garment.panels[0].warp = Eigen::Vector2d(1, 1).normalized();  // cut on the bias: now the threads run where the bias was
  const GrainStretch biased = grain_stretch(garment, worn);
  const double thread = std::sqrt((.97 * .97 + 1.08 * 1.08) / 2) - 1;
  EXPECT_NEAR((biased.warp.array() - thread).abs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR((biased.weft.array() - thread).abs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR((biased.bias.array() - .08).abs().maxCoeff(), 0, 1e-12);
}

TEST(GrainStretch, ShearLengthensOneDiagonal) {
  GarmentMesh garment = tube_of_cloth(.10, .4, 60, 20);
  const double tangent = .1;  // every thread keeps its length to second order, the diagonal does not
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, garment.panels[0].rest.cols());
  flat.row(0) = garment.panels[0].rest.row(0) + tangent * garment.panels[0].rest.row(1);
  flat.row(1) = garment.panels[0].rest.row(1);
  garment.triangles = garment.panels[0].triangles;
  garment.vertex_count = static_cast<int>(flat.cols());
  garment.welded[0] = Eigen::VectorXi::LinSpaced(flat.cols(), 0, static_cast<int>(flat.cols()) - 1);
  for (const double side : {1., -1.}) {
    flat.row(0) *= side;
    const GrainStretch stretch = grain_stretch(garment, flat);
    EXPECT_NEAR(stretch.weft.cwiseAbs().maxCoeff(), 0, 1e-12);
    EXPECT_NEAR((stretch.warp.array() - (std::hypot(1, tangent) - 1)).abs().maxCoeff(), 0, 1e-12);
    EXPECT_NEAR((stretch.bias.array() - (std::hypot(1 + tangent, 1) / std::sqrt(2) - 1)).abs().maxCoeff(), 0, 1e-12);
  }
  EXPECT_THROW(grain_stretch(garment, flat.leftCols(4)), std::invalid_argument);
}

}  // namespace
}  // namespace toile
