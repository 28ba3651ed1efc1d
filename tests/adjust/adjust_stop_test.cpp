#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "adjust/stand_ins.h"

namespace toile {
namespace {

TEST(Adjust, KeepsTheNearestStepWhenLaterOnesDriftAway) {
  const HandMade made = sheet();
  const Target target = target_of(made, pull(), true);
  int calls = 0;
  const Simulate drifting = [&](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance) {
    Drape drape = stretches_by(pull())(garment, start, tolerance);
    drape.positions.row(2).array() += .004 * calls++ * (1 + drape.positions.row(1).array());
    return drape;
  };
  const Adjustment result = adjust(target, drifting, {}, exact());
  EXPECT_EQ(result.stop, AdjustStop::stalled);
  EXPECT_EQ(result.best, 1);
  for (const AdjustStep& step : result.steps) EXPECT_GE(step.hausdorff, result.steps[1].hausdorff);
  EXPECT_EQ(result.steps.size(), 4u);  // a second try, half as far, before giving up
}

TEST(Adjust, StopsAtTheStepLimitWithoutRepeatingItself) {
  const HandMade made = sheet();
  const Target target = target_of(made, Eigen::Matrix2d::Identity(), false);
  AdjustOptions options = exact();
  options.most_steps = 2;
  const Adjustment result = adjust(target, hardens(), {}, options);
  EXPECT_EQ(result.stop, AdjustStop::step_limit);
  EXPECT_EQ(result.steps.size(), 3u);
  EXPECT_EQ(result.best, 2);
}

TEST(Adjust, SaysSoWhenTheGarmentSlipsOff) {
  const HandMade made = sheet();
  const Target target = target_of(made, Eigen::Matrix2d::Identity(), false);
  int calls = 0;
  const Simulate falls = [&](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance) {
    Drape drape = stretches_by(Eigen::Matrix2d(Eigen::Vector2d(.98, 1.1).asDiagonal()))(garment, start, tolerance);
    if (calls++ > 0) drape.positions.row(1).array() -= .8;
    return drape;
  };
  const Adjustment result = adjust(target, falls, {}, exact());
  EXPECT_EQ(result.stop, AdjustStop::slipped);
  EXPECT_EQ(result.steps.size(), 3u);  // nothing is gained by going on from the floor
  EXPECT_NEAR(result.steps[1].slipped, .8, .1);
}

TEST(Adjust, CutsTheFlatteningWhenNoStepIsNearer) {
  const HandMade made = sheet();
  const Target target = target_of(made, pull(), false);
  int calls = 0;
  const Simulate worse = [&](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance) {
    Drape drape = stretches_by(Eigen::Matrix2d(Eigen::Vector2d(.98, 1.05).asDiagonal()))(garment, start, tolerance);
    const int call = calls++;
    if (call > 0 && call < 3) drape.positions.row(2).array() += .2 * drape.positions.row(1).array();
    return drape;
  };
  const MakeCuttable rounds = [](const RestShape& rest) {
    RestShape rounded = rest;
    for (Eigen::Matrix2Xd& panel : rounded) panel = (panel.array() * 3333).round().matrix() / 3333;
    return rounded;
  };
  const Adjustment result = adjust(target, worse, rounds, exact());
  ASSERT_EQ(result.steps.size(), 4u);
  EXPECT_EQ(result.stop, AdjustStop::stalled);
  EXPECT_EQ(result.best, 3);
  EXPECT_EQ(result.rest, rounds(result.flattened));
}

// A cap of a sphere: cloth cannot be laid over it.
Eigen::Matrix3Xd bulged(const Eigen::Matrix2Xd& flat, double radius) {
  Eigen::Matrix3Xd at = in_space(flat);
  const Eigen::Vector2d centre = flat.rowwise().mean();
  for (Eigen::Index v = 0; v < at.cols(); ++v) {
    const Eigen::Vector2d d = flat.col(v) - centre;
    const double angle = d.norm() / radius;
    if (d.norm() > 0) at.col(v).head<2>() = centre + d / d.norm() * radius * std::sin(angle);
    at(2, v) = radius * std::cos(angle);
  }
  return at;
}

TEST(Adjust, NamesATargetThatCannotBeCutBeforeItSimulatesIt) {
  const HandMade made = sheet();
  for (const bool with_source : {false, true}) {
    Target target = target_of(made, Eigen::Matrix2d::Identity(), with_source);
    target.positions = bulged(made.garment.panels[0].rest, .2);
    int calls = 0;
    const Simulate counted = [&](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance) {
      ++calls;
      return stretches_by(Eigen::Matrix2d::Identity())(garment, start, tolerance);
    };
    const Adjustment result = adjust(target, counted, {});
    EXPECT_EQ(result.stop, AdjustStop::not_developable);
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(result.steps.size(), 1u);
    EXPECT_EQ(result.best, 0);
    EXPECT_GT(result.steps[0].embedding_distortion, .02);
    EXPECT_EQ(result.rest, result.flattened);
  }
}

TEST(Adjust, DoesNotMistakeStretchedClothForOneThatCannotBeCut) {
  const HandMade made = sheet();
  // The source stretches over the same bulge: that is no change of pattern.
  Target target;
  target.garment = made.garment;
  target.source = target.positions = bulged(made.garment.panels[0].rest, .2);
  const Simulate as_source = [&](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double) {
    const Eigen::Matrix2Xd& rest = garment.panels[0].rest;
    Drape drape = settled(bulged(rest, .2));
    drape.positions.colwise() += Eigen::Vector3d(start.rowwise().mean() - drape.positions.rowwise().mean());
    return drape;
  };
  const Adjustment result = adjust(target, as_source, {}, exact());
  EXPECT_GT(result.steps[0].embedding_distortion, .02);
  EXPECT_EQ(result.stop, AdjustStop::agreed);
  EXPECT_LT((result.rest[0] - made.garment.panels[0].rest).colwise().norm().maxCoeff(), 1e-9);
}

TEST(Adjust, DoesNotBelieveADrapeThatNeverCameToRest) {
  const HandMade made = sheet();
  const Target target = target_of(made, pull(), false);
  int calls = 0;
  const Simulate stuck = [&](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance) {
    Drape drape = stretches_by(pull())(garment, start, tolerance);
    if (calls++ != 1) return drape;
    drape.positions = start;  // has not moved yet
    drape.settled = false;
    drape.residual = .9;
    return drape;
  };
  const Adjustment result = adjust(target, stuck, {}, exact());
  EXPECT_LT(result.steps[1].hausdorff, 1e-12);
  EXPECT_GT(result.best, 1);
  EXPECT_TRUE(result.drape.settled);
}

}  // namespace
}  // namespace toile
