#include <gtest/gtest.h>

#include "formats/dxf_aama/units.h"
#include "formats/dxf_text.h"

namespace toile::aama {
namespace {

struct Said {
  std::string text;
  std::map<std::string, std::string> header;
};

// Metres per unit, or 0 when the file is refused.
double unit(const Said& said, double largest, std::vector<double> notches = {}, std::vector<double> allowances = {}) {
  UnitEvidence evidence;
  evidence.style.units = said.text;
  evidence.header = said.header;
  evidence.largest = largest;
  evidence.notch_depths = std::move(notches);
  evidence.allowances = std::move(allowances);
  Report report;
  const std::optional<FileUnits> decided = decide_unit(evidence, {}, "x.dxf", report);
  EXPECT_EQ(report.ok(), decided.has_value());
  EXPECT_EQ(count(report, "aama.units"), decided ? 1 : 0);
  if (!decided) {
    const Finding* error = find(report, "aama.units-ambiguous");
    EXPECT_TRUE(error && error->fault == Fault::ambiguous && error->remedy.find("units") != std::string::npos);
  }
  return decided ? decided->in_metres : 0;
}

const Said metric{"METRIC", {}}, english{"English", {}}, nothing{"", {}};

TEST(AamaUnits, BelieveAStatementThatFits) {
  EXPECT_EQ(unit(metric, 730), 1e-3);
  EXPECT_EQ(unit(english, 30), 0.0254);
  EXPECT_EQ(unit(english, 118.2), 0.0254);  // a 3 m cloth
  EXPECT_EQ(unit({"metric", {}}, 3500), 1e-3);
  EXPECT_EQ(unit({"IMPERIAL", {}}, 30), 0.0254);
  EXPECT_EQ(unit({"", {{"$INSUNITS", "4"}}}, 730), 1e-3);
  EXPECT_EQ(unit({"", {{"$INSUNITS", "5"}}}, 73), 1e-2);
  EXPECT_EQ(unit({"", {{"$INSUNITS", "1"}, {"$MEASUREMENT", "1"}}}, 30), 0.0254);
  EXPECT_EQ(unit({"", {{"$MEASUREMENT", "1"}}}, 730), 1e-3);
  EXPECT_EQ(unit({"ENGLISH", {{"$INSUNITS", "4"}}}, 30), 0.0254);  // the text comes first
}

TEST(AamaUnits, ReadMetricAsCentimetresWhenMillimetresWouldBeTooSmall) {
  EXPECT_EQ(unit(metric, 72.9), 1e-2);
  EXPECT_EQ(unit(metric, 0.8), 1.0);
  EXPECT_EQ(unit(metric, 180, {.4, .4}), 1e-2);      // notches of 4 mm, a piece of 1.8 m
  EXPECT_EQ(unit(metric, 120, {4, 4, 5}), 1e-3);     // a pocket alone: its notches tell
  EXPECT_EQ(unit(metric, 120, {}, {10, 10}), 1e-3);  // or its allowances
}

TEST(AamaUnits, GuessOnlyWhenOneUnitFits) {
  EXPECT_EQ(unit(nothing, 767), 1e-3);
  EXPECT_EQ(unit({"", {{"$MEASUREMENT", "0"}, {"$INSUNITS", "0"}}}, 767), 1e-3);
  EXPECT_EQ(unit(nothing, 120), 1e-2);
  EXPECT_EQ(unit(nothing, 10), 0.0254);
  EXPECT_EQ(unit(nothing, 30, {.08}), 0.0254);
  EXPECT_EQ(unit(nothing, 30), 0);
  EXPECT_EQ(unit(nothing, 70), 0);
  EXPECT_EQ(unit(nothing, 200), 0);
  EXPECT_EQ(unit(nothing, 1), 0);
}

TEST(AamaUnits, AskWhenAStatementContradictsTheSizes) {
  EXPECT_EQ(unit(english, 800), 0);  // 20 m
  EXPECT_EQ(unit(metric, 9), 0);
  EXPECT_EQ(unit({"", {{"$INSUNITS", "4"}}}, 5), 0);
  EXPECT_EQ(unit({"furlongs", {}}, 30), 0);
}

TEST(AamaUnits, DoAsTheyAreTold) {
  Report report;
  EXPECT_EQ(decide_unit({}, 0.0254, "x.dxf", report), (FileUnits{"inch", 0.0254, "override"}));
  ASSERT_EQ(report.findings.size(), 1u);
  EXPECT_EQ(report.findings[0].code, "aama.units");
  EXPECT_EQ(report.findings[0].severity, Severity::note);
}

}  // namespace
}  // namespace toile::aama
