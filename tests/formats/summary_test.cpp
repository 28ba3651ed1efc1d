#include "formats/summary/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "formats/folder.h"

namespace toile {
namespace {

using Json = nlohmann::json;

RunSummary full() {
  RunSummary summary;
  summary.version = "0.1.0";
  summary.mannequin.name = "women 38";
  summary.mannequin.height = 1.68;
  summary.garment = {"skirt", 8000, 9};
  summary.drape.simulator = "fem";
  summary.drape.settled = true;
  summary.drape.residual = 8.12345678e-5;
  summary.drape.max_penetration = 2e-4;
  summary.seam_gap = 3e-4;
  summary.flattened = {.0336, .0084, .93};
  summary.adjusted.distance = {.0042, .00084, .9971};
  summary.adjusted.stop = AdjustStop::not_developable;
  AdjustStep step;
  step.hausdorff = .0168;
  summary.adjusted.steps = {step, step, step};
  summary.adjusted.seam_mismatch = 4e-4;
  summary.outlines = {3e-4, 1e-6};
  summary.findings = {{"a.b", Severity::warning, "here", "text", "remedy", Fault::bad_input}};
  summary.inputs = {{"z.dxf", "00ff"}, {"a.toml", "11"}};
  summary.files = {"report.html", "skirt.dxf"};
  return summary;
}

TEST(Summary, HasTheFieldsOfSchemaOne) {
  const Json json = Json::parse(summary_json(full()));
  EXPECT_EQ(json.at("schema"), 1);
  EXPECT_EQ(json.at("mannequin").at("height_m"), 1.68);
  EXPECT_EQ(json.at("garment").at("triangles"), 8000);
  EXPECT_EQ(json.at("garment").at("panels"), 9);
  const Json& drape = json.at("drape");
  EXPECT_EQ(drape.at("simulator"), "fem");
  EXPECT_EQ(drape.at("settled"), true);
  EXPECT_NEAR(drape.at("residual").get<double>(), 8.12346e-5, 1e-12);
  EXPECT_NEAR(drape.at("max_penetration_mm").get<double>(), .2, 1e-12);
  EXPECT_NEAR(drape.at("seam_gap_mm").get<double>(), .3, 1e-12);
  EXPECT_TRUE(drape.at("seconds").is_number());
  EXPECT_NEAR(json.at("flattened").at("hausdorff_percent").get<double>(), 2, 1e-9);
  EXPECT_NEAR(json.at("flattened").at("mean_percent").get<double>(), .5, 1e-9);
  EXPECT_NEAR(json.at("flattened").at("stretch").get<double>(), .93, 1e-9);
  const Json& adjusted = json.at("adjusted");
  EXPECT_NEAR(adjusted.at("hausdorff_percent").get<double>(), .25, 1e-9);
  EXPECT_NEAR(adjusted.at("mean_percent").get<double>(), .05, 1e-9);
  EXPECT_NEAR(adjusted.at("stretch").get<double>(), .9971, 1e-9);
  EXPECT_EQ(adjusted.at("stop"), "not_developable");
  ASSERT_EQ(adjusted.at("steps").size(), 3u);
  EXPECT_NEAR(adjusted.at("steps")[1].at("hausdorff_percent").get<double>(), 1, 1e-9);
  EXPECT_NEAR(adjusted.at("seam_mismatch_mm").get<double>(), .4, 1e-9);
  EXPECT_TRUE(adjusted.at("seconds").is_number());
  EXPECT_NEAR(json.at("outlines").at("max_deviation_mm").get<double>(), .3, 1e-9);
  EXPECT_NEAR(json.at("outlines").at("symmetry_mm").get<double>(), .001, 1e-9);
  EXPECT_EQ(json.at("files"), Json({"report.html", "skirt.dxf"}));
  EXPECT_EQ(json.at("findings")[0].at("severity"), "warning");
  EXPECT_EQ(json.at("inputs").at("z.dxf"), "00ff");
}

TEST(Summary, TheSameTwice) { EXPECT_EQ(summary_json(full()), summary_json(full())); }

TEST(Summary, RefusesWhatIsNoFigureAndNamesIt) {
  const auto refused = [](auto&& spoil) {
    RunSummary summary = full();
    spoil(summary);
    try {
      summary_json(summary);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("written");
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refused([](RunSummary& s) { s.drape.residual = nan; }).find("drape.residual"), std::string::npos);
  EXPECT_NE(refused([](RunSummary& s) { s.adjusted.distance.hausdorff = INFINITY; }).find("adjusted.hausdorff_percent"),
            std::string::npos);
  EXPECT_NE(refused([](RunSummary& s) { s.adjusted.steps[2].mean = nan; }).find("adjusted.steps[2].mean_percent"),
            std::string::npos);
  EXPECT_NE(refused([](RunSummary& s) { s.mannequin.height = 0; }).find("height_m"), std::string::npos);
  EXPECT_NE(refused([](RunSummary& s) { s.outlines.symmetry = nan; }).find("outlines.symmetry_mm"), std::string::npos);
}

TEST(Summary, BrokenTextsDoNotBreakTheFile) {
  RunSummary summary = full();
  summary.garment.name = "skirt \xff\"\n";
  EXPECT_EQ(Json::parse(summary_json(summary)).at("garment").at("name"), "skirt \xef\xbf\xbd\"\n");
}

TEST(Summary, IsWritten) {
  const test::Folder folder;
  write_summary(folder / "summary.json", full());
  EXPECT_EQ(test::contents(folder / "summary.json"), summary_json(full()));
}

}  // namespace
}  // namespace toile
