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

StyleSolution slide(const SyntheticSkirt& skirt, double by) {
  return solve_style(skirt.drape, source_triangles(skirt.drape, skirt.garment.triangles),
                     hem_slid(skirt.drape, by, -Eigen::Vector3d::UnitY()));
}

class HemSlide : public ::testing::TestWithParam<double> {};

TEST_P(HemSlide, KeepsTheNormalsAndTurnsNothingOver) {
  const SyntheticSkirt& skirt = full_skirt();
  const StyleSolution solution = slide(skirt, GetParam());
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  const NormalDeviation deviation = normal_deviation(triangles, skirt.drape, solution.positions);
  EXPECT_LT(deviation.mean, 0.5 * degree);
  EXPECT_LT(deviation.most, 3 * degree);
  EXPECT_TRUE(deviation.flipped.empty());
  EXPECT_TRUE(solution.settled);
  EXPECT_LT(tilt_energy(triangles, solution.positions), 0.05 * tilt_energy(triangles, solution.initial));
}

TEST_P(HemSlide, MeetsHardConstraintsExactly) {
  const SyntheticSkirt& skirt = full_skirt();
  const StyleSolution solution = slide(skirt, GetParam());
  EXPECT_EQ(solution.positions.leftCols((hip_row + 1) * columns), skirt.drape.leftCols((hip_row + 1) * columns));
  const auto hem = Eigen::seqN((rows - 1) * columns, columns);
  const Eigen::VectorXd dropped = skirt.drape(1, hem) - solution.positions(1, hem);
  EXPECT_LT((dropped.array() - GetParam()).abs().maxCoeff(), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(ByLength, HemSlide, ::testing::Values(0.15, -0.10));

TEST(SolveStyle, GivesTheSourceBackWhenNothingMoves) {
  const SyntheticSkirt& skirt = full_skirt();
  EXPECT_LT((slide(skirt, 0).positions - skirt.drape).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(SolveStyle, TurnsAndShiftsWithTheScene) {
  const SyntheticSkirt skirt = synthetic_skirt({.columns = 32, .rows = 60, .gores = 4});
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(2, 1, -1).normalized()).toRotationMatrix();
  const Eigen::Vector3d shift(0.4, -1, 2), down = -Eigen::Vector3d::UnitY();
  const Eigen::Matrix3Xd turned = (turn * skirt.drape).colwise() + shift;
  const auto solve = [&](const Eigen::Matrix3Xd& source, const Eigen::Vector3d& axis) {
    HardConstraints hard;
    for (int v = 0; v < 21 * 32; ++v) hard.hold(v, source.col(v));
    for (int v = 59 * 32; v < 60 * 32; ++v) hard.hold_along(v, axis, axis.dot(source.col(v)) + 0.1);
    return solve_style(source, source_triangles(source, skirt.garment.triangles), hard).positions;
  };
  const Eigen::Matrix3Xd here = solve(skirt.drape, down), there = solve(turned, turn * down);
  EXPECT_LT((((turn * here).colwise() + shift) - there).cwiseAbs().maxCoeff(), 1e-9);
}

// Where the iteration stands still, no free direction has a gradient left.
TEST(SolveStyle, EndsWhereTheFrozenEnergyIsStationary) {
  const SyntheticSkirt skirt = synthetic_skirt({.columns = 24, .rows = 12, .gores = 4});
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  HardConstraints hard;
  for (int v = 0; v < 4 * 24; ++v) hard.hold(v, skirt.drape.col(v));
  for (int v = 11 * 24; v < 12 * 24; ++v) hard.hold_along(v, -Eigen::Vector3d::UnitY(), -skirt.drape(1, v) + 0.05);
  const std::vector<SoftTerm> soft{{150, Eigen::Vector3d::UnitX(), skirt.drape(0, 150) + 0.01, 0.5}};
  StyleOptions options;
  options.tolerance = 1e-12;
  options.most_iterations = 5000;
  options.most_rounds = 0;
  const StyleSolution solution = solve_style(
      skirt.drape, triangles, hard, [&](const Eigen::Matrix3Xd&, int) { return soft; }, options);
  ASSERT_TRUE(solution.settled);
  std::vector<Eigen::Matrix2d> maps;
  for (const SourceTriangle& triangle : triangles)
    maps.push_back((1 - options.in_plane_pull) * plane_map_of(triangle, solution.positions) +
                   options.in_plane_pull * plane_map_of(triangle, solution.initial));
  Eigen::Matrix3Xd gradient = shape_gradient(triangles, maps, solution.positions);
  for (const SoftTerm& term : soft)
    gradient.col(term.vertex) +=
        2 * term.weight * (term.direction.dot(solution.positions.col(term.vertex)) - term.goal) * term.direction;
  for (int v = 0; v < 12 * 24; ++v) {
    const auto fixed = hard.vertices.find(v);
    const Eigen::VectorXd left = fixed == hard.vertices.end()
                                     ? Eigen::VectorXd(gradient.col(v))
                                     : Eigen::VectorXd(fixed->second.free.transpose() * gradient.col(v));
    EXPECT_LT(left.norm(), 1e-9) << "vertex " << v;
  }
}

TEST(SolveStyle, RefusesAPartThatNothingHolds) {
  const SyntheticSkirt skirt = synthetic_skirt({.columns = 24, .rows = 12, .gores = 4});
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  EXPECT_THROW(solve_style(skirt.drape, triangles, {}), std::invalid_argument);
}

TEST(SolveStyle, FollowsASoftTermFartherTheHeavierItIs) {
  const SyntheticSkirt skirt = synthetic_skirt({.columns = 24, .rows = 12, .gores = 4});
  const auto triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  HardConstraints hard;
  for (int v = 0; v < 24; ++v) hard.hold(v, skirt.drape.col(v));
  const auto moved = [&](double weight) {
    const SoftTerm pull{200, Eigen::Vector3d::UnitX(), skirt.drape(0, 200) + 0.02, weight};
    const auto solution =
        solve_style(skirt.drape, triangles, hard, [&](const Eigen::Matrix3Xd&, int) { return std::vector<SoftTerm>{pull}; });
    return solution.positions(0, 200) - skirt.drape(0, 200);
  };
  EXPECT_GT(moved(0.1), 1e-5);
  EXPECT_GT(moved(1), moved(0.1));
  EXPECT_NEAR(moved(1e6), 0.02, 1e-4);
}

struct HeldSkirt {
  SyntheticSkirt skirt = synthetic_skirt({.columns = 24, .rows = 12, .gores = 4});
  std::vector<SourceTriangle> triangles = source_triangles(skirt.drape, skirt.garment.triangles);
  HardConstraints hem_at(double out) const {
    HardConstraints hard;
    for (int v = 0; v < 4 * 24; ++v) hard.hold(v, skirt.drape.col(v));
    for (int v = 11 * 24; v < 12 * 24; ++v) {
      const Eigen::Vector3d way(skirt.drape(0, v), 0, skirt.drape(2, v));
      hard.hold(v, skirt.drape.col(v) + out * way.normalized());
    }
    return hard;
  }
  SoftTermsAt pull(double by) const {
    return [this, by](const Eigen::Matrix3Xd&, int) {
      return std::vector<SoftTerm>{{150, Eigen::Vector3d::UnitX(), skirt.drape(0, 150) + by, 0.5}};
    };
  }
};

TEST(SolveStyle, GivesTheSameBytesWithAMemory) {
  const HeldSkirt held;
  StyleMemory memory;
  for (const double out : {0.01, 0.02, 0.01})
    EXPECT_EQ(solve_style(held.skirt.drape, held.triangles, held.hem_at(out), held.pull(0.01), {}, &memory).positions,
              solve_style(held.skirt.drape, held.triangles, held.hem_at(out), held.pull(0.01)).positions);
}

TEST(FollowStyle, StaysWhereNothingIsOther) {
  const HeldSkirt held;
  StyleOptions options;
  options.most_iterations = 5;  // cut off early
  const auto solution = solve_style(held.skirt.drape, held.triangles, held.hem_at(0.02), held.pull(0.01), options);
  const auto reference = style_reference(solution, held.triangles, held.hem_at(0.02), held.pull(0.01), options);
  EXPECT_GT(reference.imbalance.cwiseAbs().maxCoeff(), 1e-7);
  const auto followed = follow_style(reference, held.skirt.drape, held.triangles, held.hem_at(0.02), held.pull(0.01));
  EXPECT_LT((followed.positions - solution.positions).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE(followed.settled);
  EXPECT_EQ(followed.rounds, 1);
}

// Solved to the end, a shape does not depend on the way there.
TEST(FollowStyle, ComesToTheShapeThatIsSoughtFromTheSource) {
  const HeldSkirt held;
  StyleOptions options;
  options.tolerance = 1e-11;
  options.most_iterations = 5000;
  options.most_rounds = 0;
  const auto from = solve_style(held.skirt.drape, held.triangles, held.hem_at(0.02), held.pull(0.01), options);
  ASSERT_TRUE(from.settled);
  options.tolerance = 1e-7;
  const auto reference = style_reference(from, held.triangles, held.hem_at(0.02), held.pull(0.01), options);
  options.tolerance = 1e-11;
  for (const double out : {0.03, -0.01}) {
    const auto sought = solve_style(held.skirt.drape, held.triangles, held.hem_at(out), held.pull(-0.01), options);
    const auto followed = follow_style(reference, held.skirt.drape, held.triangles, held.hem_at(out), held.pull(-0.01));
    EXPECT_TRUE(followed.settled);
    EXPECT_LE(followed.iterations, 3);
    EXPECT_GT((followed.positions - from.positions).cwiseAbs().maxCoeff(), 5e-3);
    EXPECT_LT((followed.positions - sought.positions).cwiseAbs().maxCoeff(), 1e-7);
  }
}

}  // namespace
}  // namespace toile
