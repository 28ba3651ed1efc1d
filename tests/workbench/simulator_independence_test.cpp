// The adjustment asks nothing of a simulator but Phi (paper Sec. 4): the same edit with each.

#include <gtest/gtest.h>

#include "body/parametric.h"
#include "cli/templates.h"
#include "formats/formats.h"
#include "workbench/workbench.h"

namespace toile {
namespace {

class SimulatorIndependence : public testing::TestWithParam<std::string> {};

TEST_P(SimulatorIndependence, AShorterSkirtComesNearerThanPlainFlattening) {
  const auto chart = template_file("mannequins", "women.csv");
  const Scene scene{make_body(build_mannequin(value_or_throw(read_size_chart_row(chart, "38")))),
                    value_or_throw(read_fabric(template_file("fabrics", "jersey.toml"))), find_simulator(GetParam())};
  const std::string sample = std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf";
  const Worn worn = wear(value_or_throw(read_pattern(sample)), scene, 45e-3, 1e-3);
  EXPECT_TRUE(worn.drape.settled);
  const Target target = edit(worn, scene, {{"length", {{"loop", "hem"}, {"by", "-10 cm"}}, "here"}});
  const Adjustment adjustment = adjust_pattern(worn.pattern, target, scene, {.most_steps = 2});
  const AdjustStep& flattened = adjustment.steps.front();
  const AdjustStep& best = adjustment.steps[static_cast<std::size_t>(adjustment.best)];
  EXPECT_LT(best.mean, flattened.mean);
  EXPECT_LT(best.hausdorff, flattened.hausdorff);
  EXPECT_GT(best.stretch, .99);
  EXPECT_LT(best.seam_mismatch, .5e-3);
}

INSTANTIATE_TEST_SUITE_P(All, SimulatorIndependence, testing::Values("fem", "mass-spring", TOILE_STAND_IN),
                         [](const auto& simulator) {
                           return simulator.param == "fem"           ? "Fem"
                                  : simulator.param == "mass-spring" ? "MassSpring"
                                                                     : "External";
                         });

}  // namespace
}  // namespace toile
