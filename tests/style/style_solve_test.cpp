#include "style/style_solve.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numbers>
#include <stdexcept>

#include "style/normal_deviation.h"
#include "style/synthetic_skirt.h"

namespace toile {
namespace {

using testing::synthetic_skirt;
using testing::SyntheticSkirt;

constexpr double degree = std::numbers::pi / 180;

const SyntheticSkirt& full_skirt() {
  static const SyntheticSkirt skirt = synthetic_skirt();
  return skirt;
}

// Rows of the synthetic skirt: 96 columns, row r from the waist down.
constexpr int columns = 96, rows = 60, hip_row = 20;

HardConstraints held_to_the_hip(const Eigen::Matrix3Xd& source) {
  HardConstraints hard;
  for (int v = 0; v <= hip_row * columns; ++v) hard.hold(v, source.col(v));
  for (int v = hip_row * columns; v < (hip_row + 1) * columns; ++v) hard.hold(v, source.col(v));
  return hard;
}

HardConstraints hem_slid(const Eigen::Matrix3Xd& source, double by, const Eigen::Vector3d& down) {
  HardConstraints hard = held_to_the_hip(source);
  for (int v = (rows - 1) * columns; v < rows * columns; ++v) hard.hold_along(v, down, down.dot(source.col(v)) + by);
  return hard;
}

StyleSolution slide(const SyntheticSkirt& skirt, double by, const StyleOptions& options = {}) {
  Eigen::Matrix3Xd guess = skirt.drape;
  if (getenv("LIN"))
    for (Eigen::Index v = 0; v < guess.cols(); ++v) {
      const double d = 1.05 - guess(1, v);
      if (d > .22) guess(1, v) -= by * (d - .22) / .43;
    }
  StyleOptions o = options;
  if (getenv("BETA")) o.in_plane_pull = atof(getenv("BETA"));
  if (getenv("ITS")) o.most_iterations = atoi(getenv("ITS"));
  if (getenv("TOL")) o.tolerance = atof(getenv("TOL"));
  return solve_style(guess, source_triangles(skirt.drape, skirt.garment.triangles),
                     hem_slid(skirt.drape, by, -Eigen::Vector3d::UnitY()), {}, o);
}

class HemSlide : public ::testing::TestWithParam<double> {};

TEST_P(HemSlide, KeepsTheNormalsAndTurnsNothingOver) {
  const SyntheticSkirt& skirt = full_skirt();
  const StyleSolution solution = slide(skirt, GetParam());
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  const NormalDeviation deviation = normal_deviation(triangles, skirt.drape, solution.positions);
  std::printf("slide %.2f: n mean %.3f max %.3f deg stretch %.2f..%.2f its %d settled %d tilt %.3g -> %.3g\n", GetParam(),
              deviation.mean / degree, deviation.most / degree, deviation.least_stretch, deviation.most_stretch,
              solution.iterations, solution.settled, tilt_energy(triangles, solution.initial),
              tilt_energy(triangles, solution.positions));
  EXPECT_LT(deviation.mean, 0.5 * degree);
  EXPECT_LT(deviation.most, 3 * degree);
  EXPECT_TRUE(deviation.flipped.empty());
  EXPECT_TRUE(solution.settled);
}

INSTANTIATE_TEST_SUITE_P(ByLength, HemSlide, ::testing::Values(0.15, -0.10, -0.20));

}  // namespace
}  // namespace toile
