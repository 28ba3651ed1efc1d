#include <gtest/gtest.h>

#include "workbench/workbench.h"

namespace toile {
namespace {

Drape hanging_well() {
  Drape drape;
  drape.positions = Eigen::Matrix3Xd::Constant(3, 4, .5);
  drape.settled = true;
  drape.residual = 1e-4;
  return drape;
}

const Finding* found(const Report& report, const std::string& code) {
  for (const Finding& finding : report.findings)
    if (finding.code == code) return &finding;
  return nullptr;
}

TEST(DrapeFindings, AreNoneOfAGarmentThatHangsWell) {
  EXPECT_TRUE(drape_findings(hanging_well(), 1e-3, "re-drape").findings.empty());
}

TEST(DrapeFindings, NameEachThingThatIsWrongAlone) {
  struct Wrong {
    const char* code;
    Severity severity;
    void (*make)(Drape&);
    const char* says;
  };
  for (const Wrong& wrong :
       {Wrong{"drape.not-settled", Severity::error, [](Drape& d) { d.settled = false; }, "1"},
        Wrong{"drape.penetrates", Severity::error, [](Drape& d) { d.max_penetration = 2.5e-3; }, "2.5 mm"},
        Wrong{"drape.inverted", Severity::warning, [](Drape& d) { d.inverted_triangles = 3; }, "3 triangles"},
        Wrong{"drape.self-intersects", Severity::error, [](Drape& d) { d.self_intersections = 7; }, "7 pairs"},
        Wrong{"drape.slipped", Severity::warning, [](Drape& d) { d.slipped = .041; }, "41.0 mm"},
        Wrong{"drape.below-floor", Severity::warning, [](Drape& d) { d.positions(1, 2) = -.102; }, "102 mm"}}) {
    Drape drape = hanging_well();
    wrong.make(drape);
    const Report report = drape_findings(drape, 1e-3, "re-drape");
    ASSERT_EQ(report.findings.size(), 1u) << wrong.code;
    const Finding* finding = found(report, wrong.code);
    ASSERT_TRUE(finding) << wrong.code;
    EXPECT_EQ(finding->severity, wrong.severity);
    EXPECT_EQ(finding->place, "re-drape");
    EXPECT_NE(finding->text.find(wrong.says), std::string::npos) << finding->text;
    EXPECT_FALSE(finding->remedy.empty());
  }
}

TEST(DrapeFindings, LetAHemTouchTheFloor) {
  Drape drape = hanging_well();
  drape.positions(1, 0) = -.004;
  EXPECT_TRUE(drape_findings(drape, 1e-3, "source drape").findings.empty());
}

}  // namespace
}  // namespace toile
