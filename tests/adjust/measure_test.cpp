#include <gtest/gtest.h>

#include <cmath>

#include "adjust/adjust.h"
#include "adjust/stand_ins.h"
#include "adjust/welded_seams.h"

namespace toile {
namespace {

// The panels as they were drawn, in the plane.
Target flat_target(const HandMade& made) {
  Target target;
  target.garment = made.garment;
  target.positions = Eigen::Matrix3Xd::Zero(3, made.garment.vertex_count);
  for (std::size_t p = 0; p < made.garment.panels.size(); ++p)
    for (Eigen::Index v = 0; v < made.garment.welded[p].size(); ++v)
      target.positions.col(made.garment.welded[p](v)).head<2>() = made.garment.panels[p].rest.col(v);
  return target;
}

TEST(Measure, ReadsStretchContractionAndDropInClosedForm) {
  const HandMade made = sheet();
  const Target target = flat_target(made);
  Drape drape;
  drape.positions = 1.1 * target.positions;
  drape.residual = 3e-4;
  AdjustStep step = measure(target, rest_shape(made.garment), drape);
  const double wanted = 1 - std::sqrt(2.0) * (1 - 1 / 1.1);
  EXPECT_NEAR(step.stretch, wanted, 1e-12);
  EXPECT_NEAR(step.worst_stretch, wanted, 1e-12);
  EXPECT_EQ(step.contracting, 1);
  EXPECT_EQ(step.residual, 3e-4);
  EXPECT_LT(step.seam_mismatch, 1e-12);

  drape.positions = target.positions / 1.1;
  EXPECT_EQ(measure(target, rest_shape(made.garment), drape).contracting, 0);

  drape.positions = target.positions;
  drape.positions.row(1).array() -= .03;
  step = measure(target, rest_shape(made.garment), drape);
  EXPECT_NEAR(step.slipped, .03, 1e-12);
  EXPECT_NEAR(step.stretch, 1, 1e-12);
  EXPECT_LE(step.mean, .03 + 1e-9);
}

TEST(Measure, DoesNotCallALongerHemASlip) {
  const HandMade made = sheet();
  const Target target = flat_target(made);
  Drape drape;
  drape.positions = target.positions;
  const double top = target.positions.row(1).maxCoeff();
  drape.positions.row(1) = top - 1.1 * (top - target.positions.row(1).array());
  EXPECT_LT(measure(target, rest_shape(made.garment), drape).slipped, .015);
  EXPECT_GT(measure(target, rest_shape(made.garment), drape).hausdorff, .03);
}

TEST(Measure, ATriangleThatCollapsedAgreesWithNothing) {
  const HandMade made = sheet();
  const Target target = flat_target(made);
  Drape drape;
  drape.positions = target.positions;
  drape.positions.col(made.garment.triangles(1, 0)) = drape.positions.col(made.garment.triangles(0, 0));
  const AdjustStep step = measure(target, rest_shape(made.garment), drape);
  EXPECT_TRUE(std::isfinite(step.stretch));
  EXPECT_LE(step.worst_stretch, 0);
}

TEST(WeldedSeams, TellRatiosAndWhoIsEased) {
  const HandMade made = curved_bodice(1.05);
  const std::vector<MatingEdges> mating = mating_edges(made.garment);
  EXPECT_EQ(mating.size(), 16u);  // two side seams of eight mesh edges
  for (const MatingEdges& pair : mating) {
    EXPECT_NEAR(pair.panel_a < pair.panel_b ? pair.ratio : 1 / pair.ratio, 1.05, 1e-3);
    const auto end = [&](int panel, int vertex) { return made.garment.welded[static_cast<std::size_t>(panel)](vertex); };
    EXPECT_TRUE((end(pair.panel_a, pair.a_from) == end(pair.panel_b, pair.b_from)) !=
                (end(pair.panel_a, pair.a_from) == end(pair.panel_b, pair.b_to)));
  }
  EXPECT_EQ(eased_panels(made.garment), (std::vector<bool>{true, true, true}));
  const HandMade skirt = gored_skirt();
  EXPECT_EQ(eased_panels(skirt.garment), std::vector<bool>(9, false));
  EXPECT_EQ(mating_edges(skirt.garment).size(), 8u * 20 + 8 * 8 + 4);
}

TEST(WeldedSeams, MismatchIsThatOfWholeEdges) {
  const HandMade made = gored_skirt();
  const RestShape rest =
      mapped(made.garment, [](int panel, const Eigen::Vector2d& x) -> Eigen::Vector2d { return panel == 3 ? 1.01 * x : x; });
  const double side = length(made.pattern.pieces[0].outline[1]);
  EXPECT_NEAR(seam_mismatch(made.garment, rest), .01 * side, 1e-9);
}

}  // namespace
}  // namespace toile
