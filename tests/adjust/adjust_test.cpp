#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "adjust/stand_ins.h"
#include "geometry/embed.h"

namespace toile {
namespace {

TEST(Adjust, UndoesAFixedStretchInOneStep) {  // T* = A^-1 t^g, Eq. 6
  const HandMade made = sheet();
  // With A and the edit symmetric and commuting nothing turns, so one step is exact, from either start.
  const Eigen::Matrix2d a = Eigen::Vector2d(.97, 1.12).asDiagonal();
  for (const bool with_source : {false, true}) {
    Target target = target_of(made, a, with_source);
    target.positions = in_space(Eigen::Vector2d(1.05, 1.2).asDiagonal() * a * made.garment.panels[0].rest);
    const Adjustment result = adjust(target, stretches_by(a), {}, exact());
    ASSERT_EQ(result.steps.size(), 2u);
    EXPECT_EQ(result.best, 1);
    EXPECT_EQ(result.stop, AdjustStop::agreed);
    EXPECT_NEAR(result.steps[1].worst_stretch, 1, 1e-9);
    EXPECT_LT(result.steps[1].hausdorff, 1e-9);
    EXPECT_GT(result.steps[0].hausdorff, .03);
    const Eigen::Matrix2d edit = Eigen::Vector2d(1.05, 1.2).asDiagonal();
    const Eigen::Matrix2Xd wanted = edit * made.garment.panels[0].rest;
    const Eigen::Matrix2Xd got = result.rest[0];
    EXPECT_LT(
        ((got.colwise() - got.rowwise().mean()) - (wanted.colwise() - wanted.rowwise().mean())).colwise().norm().maxCoeff(),
        1e-9);
  }
}

TEST(Adjust, StartsFromTheFlatteningAndKeepsIt) {
  const HandMade made = sheet();
  const Target target = target_of(made, pull(), true);
  const Adjustment result = adjust(target, stretches_by(pull()), {});
  // Laid flat the target is itself, so its drape is stretched twice.
  const Eigen::Matrix2Xd flat = target.positions.topRows(2);
  const Eigen::Matrix2Xd& got = result.flattened[0];
  for (Eigen::Index v = 1; v < flat.cols(); ++v)
    EXPECT_NEAR((flat.col(v) - flat.col(0)).norm(), (got.col(v) - got.col(0)).norm(), 1e-9);
  EXPECT_EQ(result.flattened_drape.positions.cols(), flat.cols());
  EXPECT_LT(result.steps[0].embedding_distortion, 1e-9);
}

TEST(Adjust, ConvergesOnAStretchThatDependsOnTheShape) {
  const HandMade made = sheet();
  const Target target = target_of(made, Eigen::Matrix2d::Identity(), false);
  AdjustOptions options = exact();
  options.most_steps = 20;
  options.damping = 1;
  options.agreed_hausdorff = 1e-6;
  const Adjustment result = adjust(target, hardens(), {}, options);
  EXPECT_EQ(result.stop, AdjustStop::agreed);
  for (std::size_t k = 1; k < result.steps.size(); ++k)
    EXPECT_LT(result.steps[k].hausdorff, .5 * result.steps[k - 1].hausdorff);
}

TEST(Adjust, PrefersAPatternThatCanBeCutToAFlatteningThatAgreesToo) {
  const HandMade made = sheet();
  const Target target = target_of(made, Eigen::Matrix2d::Identity(), true);
  const MakeCuttable rounds = [](const RestShape& rest) {
    RestShape rounded = rest;
    for (Eigen::Matrix2Xd& panel : rounded) panel = (panel.array() * 3333).round().matrix() / 3333;
    return rounded;
  };
  const Adjustment result = adjust(target, stretches_by(Eigen::Matrix2d::Identity()), rounds);
  EXPECT_LT(result.steps[0].hausdorff, result.steps[1].hausdorff);
  EXPECT_EQ(result.stop, AdjustStop::agreed);
  EXPECT_EQ(result.best, 1);
}

TEST(Adjust, CutsEveryStepButTheFlattening) {
  const HandMade made = sheet();
  const Target target = target_of(made, pull(), true);
  std::vector<RestShape> cut;
  const MakeCuttable rounds = [&](const RestShape& rest) {
    RestShape rounded = rest;
    for (Eigen::Matrix2Xd& panel : rounded) panel = (panel.array() * 1e3).round().matrix() / 1e3;
    cut.push_back(rounded);
    return rounded;
  };
  int reported = 0;
  AdjustOptions options;
  options.progress = [&](const AdjustStep&) { ++reported; };
  const Adjustment result = adjust(target, stretches_by(pull()), rounds, options);
  EXPECT_EQ(cut.size() + 1, result.steps.size());
  EXPECT_EQ(static_cast<std::size_t>(reported), result.steps.size());
  ASSERT_GT(result.best, 0);
  EXPECT_EQ(result.rest, cut[static_cast<std::size_t>(result.best - 1)]);
}

// Both sheets are laid side by side as one: the longer one is pushed together along the seam, as simulators do.
Simulate sews_flat(const GarmentMesh& source, const Eigen::Matrix2d& stretch) {
  return [&source, stretch](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double) {
    const Embedder whole({{source.vertex_count, source.triangles}}, {}, rest_triangles(source),
                         {.most_iterations = 400, .tolerance = 1e-10});
    std::vector<Eigen::Matrix2d> shapes = rest_triangles(garment);
    for (Eigen::Matrix2d& shape : shapes) shape = stretch * shape;
    return settled(in_space(whole.embed(shapes, {Eigen::Matrix2Xd(start.topRows(2))}).panels[0]));
  };
}

Eigen::Matrix3Xd side_by_side(const GarmentMesh& garment) {
  Eigen::Matrix2Xd at(2, garment.vertex_count);
  for (std::size_t p = 0; p < 2; ++p)
    for (Eigen::Index v = 0; v < garment.welded[p].size(); ++v)
      at.col(garment.welded[p](v)) = garment.panels[p].rest.col(v) + Eigen::Vector2d(.24 * static_cast<double>(p), 0);
  return in_space(at);
}

TEST(Adjust, KeepsTheEaseOfASeam) {
  const HandMade made = two_sheets(1.04);
  const Simulate simulate = sews_flat(made.garment, Eigen::Vector2d(.97, 1.08).asDiagonal());
  Target target;
  target.garment = made.garment;
  target.source = simulate(made.garment, side_by_side(made.garment), 0).positions;
  target.positions = target.source;
  target.positions.row(1) *= 1.1;
  for (const bool from_source : {true, false}) {
    AdjustOptions options;
    options.start_from_source = from_source;
    const Adjustment result = adjust(target, simulate, {}, options);
    ASSERT_GT(result.best, 0);
    EXPECT_LT(result.steps[static_cast<std::size_t>(result.best)].seam_mismatch, from_source ? .1e-3 : 2.5e-3);
    EXPECT_LT(result.steps[static_cast<std::size_t>(result.best)].hausdorff, .4 * result.steps[0].hausdorff);
    EXPECT_GT(result.steps[0].seam_mismatch, .02);  // plain flattening makes both sides alike
    const auto height = [&](std::size_t p) { return result.rest[p].row(1).maxCoeff() - result.rest[p].row(1).minCoeff(); };
    EXPECT_NEAR(height(1) / height(0), 1.04, 2e-3);
  }
}

TEST(Adjust, RefusesSizesThatDoNotFit) {
  const HandMade made = sheet();
  Target target = target_of(made, pull(), true);
  target.positions.conservativeResize(3, 5);
  EXPECT_THROW(adjust(target, stretches_by(pull()), {}), std::invalid_argument);
  target = target_of(made, pull(), true);
  target.positions(1, 3) = std::nan("");
  EXPECT_THROW(adjust(target, stretches_by(pull()), {}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
