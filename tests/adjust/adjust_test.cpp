#include "adjust/adjust.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "draft/hand_made.h"
#include "geometry/embed.h"

namespace toile {
namespace {

// A rectangle, 24 by 60 cm.
HandMade sheet() {
  HandMade made;
  Piece piece;
  piece.name = "sheet";
  piece.outline = {edge("hem", {{0, 0}, {.24, 0}}), edge("right", {{.24, 0}, {.24, .6}}), edge("top", {{.24, .6}, {0, .6}}),
                   edge("left", {{0, .6}, {0, 0}})};
  made.pattern.pieces = {piece};
  made.grids = {{{{{0}, {1}, {2}, {3}}}, {6, 15, 6, 15}}};
  mesh(made);
  return made;
}

// Two of them side by side, the right one `ease` times as long as the left one where they are sewn together.
HandMade two_sheets(double ease) {
  HandMade made = sheet();
  made.pattern.pieces.push_back(made.pattern.pieces[0]);
  made.pattern.pieces[1].name = "other";
  for (Edge& e : made.pattern.pieces[1].outline)
    for (OutlinePoint& point : e.points) point.at.y() *= ease;
  made.grids.push_back(made.grids[0]);
  made.pattern.seams = {{"seam", {"sheet", 1, "right", 0, 1}, {"other", 1, "left", 1, 0}, false}};
  mesh(made);
  return made;
}

Eigen::Matrix3Xd in_space(const Eigen::Matrix2Xd& flat) {
  Eigen::Matrix3Xd at = Eigen::Matrix3Xd::Zero(3, flat.cols());
  at.topRows(2) = flat;
  return at;
}

Drape settled(Eigen::Matrix3Xd positions) {
  Drape drape;
  drape.positions = std::move(positions);
  drape.settled = true;
  return drape;
}

// t = A T: the sheet stretched as a whole. Gravity pulls the same whatever the panel's shape.
Simulate stretches_by(const Eigen::Matrix2d& a) {
  return [a](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double) {
    Eigen::Matrix2Xd flat = a * garment.panels[0].rest;
    flat.colwise() += Eigen::Vector2d(start.topRows(2).rowwise().mean() - flat.rowwise().mean());
    return settled(in_space(flat));
  };
}

Eigen::Matrix2d pull() {
  Eigen::Matrix2d a;
  a << .97, .03, .03, 1.12;
  return a;
}

// The source stretched by `a`, lengthened by `longer` and bent by a shear that grows downwards.
Target target_of(const HandMade& made, const Eigen::Matrix2d& a, bool with_source) {
  Target target;
  target.garment = made.garment;
  const Eigen::Matrix2Xd source = a * made.garment.panels[0].rest;
  if (with_source) target.source = in_space(source);
  Eigen::Matrix2d edit;
  edit << 1.05, .02, .02, 1.2;
  target.positions = in_space(edit * source);
  return target;
}

AdjustOptions exact() {
  AdjustOptions options;
  options.agreed_hausdorff = 1e-9;
  return options;
}

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

// Cloth that resists more the more it is pulled: the stretch depends on the rest shape.
Simulate hardens() {
  return [](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double) {
    const Eigen::Matrix2Xd& rest = garment.panels[0].rest;
    const double height = rest.row(1).maxCoeff() - rest.row(1).minCoeff();
    return stretches_by(Eigen::Vector2d(1 - .05 * height, 1 + .2 * height).asDiagonal())(garment, start, 0);
  };
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
  EXPECT_EQ(result.steps.size(), 2u);
  EXPECT_EQ(result.best, 0);
  EXPECT_NEAR(result.steps[1].slipped, .8, .1);
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
    if (calls++ == 0) return drape;
    drape.positions = start;  // has not moved yet
    drape.settled = false;
    drape.residual = .9;
    return drape;
  };
  const Adjustment result = adjust(target, stuck, {}, exact());
  EXPECT_EQ(result.best, 0);
  EXPECT_NE(result.stop, AdjustStop::agreed);
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
