// Targets that no pattern drapes into, each named with its place, and one beside them that one does.

#include "workbench/judgement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "body/parametric.h"
#include "cli/templates.h"
#include "cut/cut.h"
#include "formats/formats.h"

namespace toile {
namespace {

struct Skirt {
  Scene scene;
  Worn worn;
  double waist = 0, hem = 0;  // m above the floor
};

// The sample in cotton on a coarse mesh.
const Skirt& skirt() {
  static const Skirt one = [] {
    Skirt made;
    const auto chart = template_file("mannequins", "women.csv");
    made.scene = {make_body(build_mannequin(value_or_throw(read_size_chart_row(chart, "38")))),
                  value_or_throw(read_fabric(template_file("fabrics", "cotton_poplin.toml"))), find_simulator("fem")};
    const std::string sample = std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf";
    made.worn = wear(value_or_throw(read_pattern(sample)), made.scene, 45e-3, 1e-3);
    made.waist = made.worn.drape.positions.row(1).maxCoeff();
    made.hem = made.worn.drape.positions.row(1).minCoeff();
    return made;
  }();
  return one;
}

// The drape with every point moved out from the axis by `factor(height share)`: 0 at the hem, 1 at the waist.
template <class Factor>
Target widened(const Factor& factor) {
  const Skirt& s = skirt();
  Target target;
  target.garment = s.worn.garment;
  target.source = target.positions = s.worn.drape.positions;
  const Eigen::Vector3d axis = target.source.rowwise().mean();
  for (Eigen::Index v = 0; v < target.positions.cols(); ++v) {
    const double by = factor((target.source(1, v) - s.hem) / (s.waist - s.hem));
    for (const int i : {0, 2}) target.positions(i, v) = axis(i) + by * (target.source(i, v) - axis(i));
  }
  return target;
}

struct Outcome {
  Adjustment adjustment;
  Report report;
};

Outcome tried(const Target& target) {
  const Skirt& s = skirt();
  Outcome outcome;
  outcome.adjustment = adjust_pattern(s.worn.pattern, target, s.scene, {.most_steps = 1});
  const Redrawn redrawn = redraw(s.worn.pattern, target.garment, outcome.adjustment.rest);
  const Verified verified = verify(redrawn.pattern, target, outcome.adjustment.rest, s.scene, 1e-3);
  outcome.report = judge({target, outcome.adjustment, verified, redrawn.seam_mismatch,
                          tailoring_difference(target.garment, target.positions, verified.drape.positions), s.scene.body.form});
  return outcome;
}

const Finding* find(const Report& report, const std::string& code) {
  for (const Finding& finding : report.findings)
    if (finding.code == code) return &finding;
  return nullptr;
}

std::string all(const Report& report) {
  std::string text;
  for (const Finding& finding : report.findings) text += in_words(finding) + "\n";
  return text;
}

TEST(Judgement, ABulgeCannotBeCutAndIsPlaced) {
  const Outcome outcome = tried(widened([](double h) { return 1 + .3 * std::exp(-std::pow((h - .5) / .08, 2)); }));
  const Finding* finding = find(outcome.report, "adjust.not-developable");
  ASSERT_NE(finding, nullptr) << all(outcome.report);
  EXPECT_EQ(finding->place.rfind("panel 'GORE", 0), 0u) << finding->place;
  const double height = std::stod(finding->place.substr(finding->place.find(", ") + 2)) * 1e-3;
  EXPECT_NEAR(height, skirt().hem + .5 * (skirt().waist - skirt().hem), .12) << finding->place;
  EXPECT_EQ(finding->fault, Fault::checks_failed);
}

TEST(Judgement, APinchCannotBeCut) {
  const Outcome outcome = tried(widened([](double h) { return 1 - .3 * std::exp(-std::pow((h - .3) / .08, 2)); }));
  EXPECT_NE(find(outcome.report, "adjust.not-developable"), nullptr) << all(outcome.report);
}

TEST(Judgement, ALampshadeIsNotHowClothHangs) {  // a cone with its hem half as wide again
  const Outcome outcome = tried(widened([](double h) { return 1 + .5 * std::max(0.0, 1 - h / .7); }));
  EXPECT_FALSE(outcome.report.ok());
  const Finding* finding = find(outcome.report, "adjust.far-from-target");
  if (!finding) finding = find(outcome.report, "adjust.not-developable");
  ASSERT_NE(finding, nullptr) << all(outcome.report);
  EXPECT_EQ(finding->place.rfind("panel '", 0), 0u) << finding->place;
}

TEST(Judgement, AWaistTooLooseSlips) {
  const Outcome outcome = tried(widened([](double) { return 1.25; }));
  const Finding* finding = find(outcome.report, "adjust.slips");
  if (!finding) finding = find(outcome.report, "adjust.far-from-target");
  ASSERT_NE(finding, nullptr) << all(outcome.report);
}

// What flattening without the rules of cutting reaches, and the cut pattern does not, is no matter of how cloth hangs.
TEST(Judgement, TheRulesOfCuttingAreNamedWhereTheyCost) {
  const Skirt& s = skirt();
  Target target = widened([](double) { return 1; });
  Adjustment adjustment;
  adjustment.steps.resize(2);
  adjustment.flattened = rest_shape(target.garment);
  Verified verified;
  verified.rest = adjustment.flattened;
  verified.drape = s.worn.drape;
  verified.step.hausdorff = 0.04;
  TailoringDifference tailoring;
  tailoring.girth = 0.05;
  const auto code = [&](double flattened) {
    adjustment.steps.front().hausdorff = flattened;
    const Report report = judge({target, adjustment, verified, 0, tailoring, s.scene.body.form});
    return report.findings.empty() ? "" : report.findings.front().code;
  };
  EXPECT_EQ(code(0.015), "adjust.cutting-rules");
  EXPECT_EQ(code(0.035), "adjust.far-from-target");
}

TEST(Judgement, AShorterSkirtIsNotSuspected) {
  const Target target = edit(skirt().worn, skirt().scene, {{"length", {{"loop", "hem"}, {"by", "-6 cm"}}, "here"}});
  const Outcome outcome = tried(target);
  EXPECT_TRUE(outcome.report.ok()) << all(outcome.report);
}

}  // namespace
}  // namespace toile
