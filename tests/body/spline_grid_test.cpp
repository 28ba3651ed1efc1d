#include "body/spline_grid.h"

#include <gtest/gtest.h>

#include "body/points.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

TEST(SplineGrid, TakesTheSamplesAtTheNodes) {
  GridFrame grid{{.1, -.2, .3}, .05, {7, 9, 8}};
  test::Points points(11);
  std::vector<float> samples(grid.nodes());
  for (float& sample : samples) sample = static_cast<float>(points.between(-1, 1));
  const SplineGrid spline(grid, samples, 2);
  for (int k = 1; k < grid.size[2] - 1; ++k)
    for (int j = 1; j < grid.size[1] - 1; ++j)
      for (int i = 1; i < grid.size[0] - 1; ++i)
        EXPECT_NEAR(spline.value(grid.at(i, j, k)), samples[grid.index(i, j, k)], 2e-6);
}

TEST(SplineGrid, ReproducesALinearFunctionAwayFromTheEnds) {
  GridFrame grid{Vec::Zero(), .05, {40, 40, 40}};
  const Vec slope(.3, -.7, .5);
  std::vector<float> samples(grid.nodes());
  for (int k = 0; k < 40; ++k)
    for (int j = 0; j < 40; ++j)
      for (int i = 0; i < 40; ++i) samples[grid.index(i, j, k)] = static_cast<float>(slope.dot(grid.at(i, j, k)));
  const SplineGrid spline(grid, samples, 1);
  const SplineSample found = spline.sample({1.013, .977, 1.031});
  EXPECT_NEAR(found.value, slope.dot(Vec(1.013, .977, 1.031)), 1e-6);
  EXPECT_LT((found.gradient - slope).norm(), 2e-5);
  EXPECT_LT(found.hessian.norm(), 1e-3);
}

}  // namespace
}  // namespace toile
