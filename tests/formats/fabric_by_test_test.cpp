#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "formats/fabric/test_results.h"
#include "formats/formats.h"

namespace toile {
namespace {

const std::string crepe = R"(name = "crepe"
friction = 0.4
thickness = "0.5 mm"
most_stretch = "9 %"

[test]
weight = "240 g/m^2"
strip_width = "5 cm"
warp = "100 g at 1.1 %"
weft = "100 g at 1.9 %"
bias = "20 g at 2.1 %"
narrowing = 0.25
bending_length_warp = "1.9 cm"
bending_length_weft = "1.7 cm"
)";

class FabricByTest : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) / (std::string("toile_tested_fabric_") + test.name() + ".toml");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Loaded<Fabric> read(const std::string& text) {
    std::ofstream(file_) << text;
    return read_fabric(file_);
  }

  static std::string changed(const std::string& from, const std::string& to) {
    std::string text = crepe;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
  }

  Finding first_error(const std::string& from, const std::string& to) {
    const auto loaded = read(changed(from, to));
    EXPECT_FALSE(loaded.value) << from;
    const Finding finding = loaded.report.findings.empty() ? Finding{} : loaded.report.findings[0];
    EXPECT_FALSE(finding.remedy.empty()) << finding.code;
    return finding;
  }

  std::filesystem::path file_;
};

// Stretch under a tension, by bisection, of a strip at `angle` to the warp, free to narrow and to shear: all Green strains
// follow from the stress s along the strip, and the tension is (1 + e) s.
double stretch_of(const Fabric& cloth, double angle, double tension) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double det = cloth.stretch_warp * cloth.stretch_weft - cloth.stretch_cross * cloth.stretch_cross;
  const auto green = [&](double stress) {
    const double s11 = stress * c * c, s22 = stress * s * s, s12 = stress * c * s;
    const double e11 = (cloth.stretch_weft * s11 - cloth.stretch_cross * s22) / det;
    const double e22 = (cloth.stretch_warp * s22 - cloth.stretch_cross * s11) / det;
    return c * c * e11 + s * s * e22 + c * s * s12 / cloth.shear;
  };
  double low = 0, high = tension;
  for (int i = 0; i < 200; ++i) {
    const double stress = (low + high) / 2;
    (std::sqrt(1 + 2 * green(stress)) * stress < tension ? low : high) = stress;
  }
  return std::sqrt(1 + 2 * green(low)) - 1;
}

TEST_F(FabricByTest, StretchesExactlyAsItDidOnTheHook) {
  const auto loaded = read(crepe);
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.at(0));
  const Fabric& cloth = *loaded.value;
  const double gram = 9.80665e-3 / .05;  // N/m on 5 cm
  EXPECT_NEAR(stretch_of(cloth, 0, 100 * gram), .011, 1e-9);
  EXPECT_NEAR(stretch_of(cloth, M_PI / 2, 100 * gram), .019, 1e-9);
  EXPECT_NEAR(stretch_of(cloth, M_PI / 4, 20 * gram), .021, 1e-9);
  EXPECT_NEAR(cloth.stretch_cross / cloth.stretch_weft, .25, 1e-12);
}

TEST_F(FabricByTest, BendsByItsBendingLengthCubed) {
  const auto loaded = read(crepe);
  ASSERT_TRUE(loaded.value);
  EXPECT_NEAR(loaded.value->area_density, .24, 1e-12);
  EXPECT_NEAR(loaded.value->bend_warp, .24 * 9.80665 * std::pow(.019, 3), 1e-15);
  EXPECT_NEAR(loaded.value->bend_weft, .24 * 9.80665 * std::pow(.017, 3), 1e-15);
  // The plain wool of README.md: 168 g/m^2 and 15 mm make 5.56 uN m by FAST-2.
  EXPECT_NEAR(bending_stiffness(.168, .015), 5.56e-6, .005e-6);
}

// Threads that do not give: shear is tension over four times the stretch, FAST-3's 123 / EB5 at 5 gf/cm.
TEST(StripTests, OfStiffThreadsAreTheFastRuleForShear) {
  const double tension = 5 * .980665;
  for (const double percent : {.5, 1., 2.}) {
    StripTests tests{{tension, 1e-9}, {tension, 1e-9}, {tension, percent / 100}, 0.};
    EXPECT_NEAR(membrane_stiffness(tests)->shear, 123 / percent, .02 * 123 / percent * (1 + percent));
  }
}

TEST(StripTests, WithoutNarrowingCoupleAFifthOfTheWeakerWay) {
  const StripTest soft{20, .03}, firm{20, .01}, bias{20, .1};
  for (const auto& [warp, weft] : {std::pair{soft, firm}, std::pair{firm, soft}}) {
    const auto found = membrane_stiffness({warp, weft, bias, {}});
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->cross, .2 * std::min(found->warp, found->weft), 1e-9 * found->warp);
  }
}

TEST_F(FabricByTest, MayStandForOnlyAPart) {
  const auto loaded = read(R"(area_density = "240 g/m^2"
stretch_warp = "2000 N/m"
stretch_weft = "1200 N/m"
stretch_cross = "200 N/m"
shear = "50 N/m"
bend_weft = "11 uN m"
friction = 0.4
thickness = "0.5 mm"
most_stretch = "9 %"
[test]
bending_length_warp = "19 mm"
)");
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.at(0));
  EXPECT_NEAR(loaded.value->bend_warp, bending_stiffness(.24, .019), 1e-15);
  EXPECT_NEAR(loaded.value->bend_weft, 11e-6, 1e-15);
}

TEST_F(FabricByTest, ComplaintsNameTheLineAndTheRemedy) {
  const Finding no_stretch = first_error("100 g at 1.1 %", "100 g");
  EXPECT_EQ(no_stretch.code, "fabric.bad-value");
  EXPECT_EQ(no_stretch.place, file_.filename().string() + ":9");
  EXPECT_NE(no_stretch.remedy.find("at 1.5 %"), std::string::npos) << no_stretch.remedy;
  EXPECT_EQ(first_error("100 g at 1.1 %", "1.1 % at 100 g").code, "fabric.bad-value");
  EXPECT_EQ(first_error("\"20 g at 2.1 %\"", "2.1").code, "fabric.bad-value");
  EXPECT_EQ(first_error("100 g at 1.1 %", "100 g at 0 %").code, "fabric.out-of-range");
  EXPECT_EQ(first_error("1.9 cm", "1.9 m").code, "fabric.out-of-range");
  EXPECT_EQ(first_error("bias = \"20 g at 2.1 %\"\n", "").code, "fabric.missing");
  EXPECT_EQ(first_error("strip_width = \"5 cm\"\n", "").code, "fabric.missing");
  EXPECT_EQ(first_error("weight = \"240 g/m^2\"\n", "").code, "fabric.missing");
  EXPECT_EQ(first_error("narrowing", "narrows").code, "fabric.unknown-key");
  EXPECT_EQ(first_error("0.25", "1.9").code, "fabric.test-contradicts");
  EXPECT_EQ(first_error("20 g at 2.1 %", "200 g at 0.5 %").code, "fabric.test-contradicts");
  EXPECT_EQ(first_error("100 g at 1.1 %", "2000 g at 12 %").code, "fabric.test-beyond-limit");
  const Finding twice = first_error("friction", "bend_warp = \"9 uN m\"\nfriction");
  EXPECT_EQ(twice.code, "fabric.given-twice");
  EXPECT_EQ(twice.place, file_.filename().string() + ":2");
  const auto no_table = read("test = 3\n");
  EXPECT_EQ(no_table.report.findings.at(0).code, "fabric.bad-value");
}

// The example of templates/fabrics/README.md is read as it stands there.
TEST_F(FabricByTest, ReadsTheExampleOfTheReadme) {
  std::ifstream readme(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics/README.md");
  std::string text, line;
  bool inside = false;
  while (std::getline(readme, line)) {
    if (line == "```") inside = false;
    if (inside) text += line + '\n';
    if (line == "```toml") inside = true;
  }
  const auto loaded = read(text);
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.at(0));
  EXPECT_EQ(loaded.value->bend_warp, read(crepe).value->bend_warp);
}

}  // namespace
}  // namespace toile
