#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "formats/formats.h"

namespace toile {
namespace {

const std::string cloth = R"(name = "cloth"
area_density = "12 oz/yd^2"
stretch_warp = "100 gf/cm"
stretch_weft = "0.8 kN/m"
stretch_cross = "10 N/m"
shear = "50 N/m"
bend_warp = "0.1 gf cm^2/cm"
bend_weft = "6 µN·m"
friction = 0.4
thickness = "0.3 mm"
most_stretch = "8 %"
)";

class FabricFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    file_ = std::filesystem::path(testing::TempDir()) / (std::string("toile_fabric_") + test.name() + ".toml");
  }
  void TearDown() override { std::filesystem::remove(file_); }

  Loaded<Fabric> read(const std::string& text) {
    std::ofstream(file_) << text;
    return read_fabric(file_);
  }

  Finding first_error(const std::string& from, const std::string& to) {
    std::string text = cloth;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    const auto loaded = read(text.replace(at, from.size(), to));
    EXPECT_FALSE(loaded.value);
    return loaded.report.findings.empty() ? Finding{} : loaded.report.findings[0];
  }

  std::filesystem::path file_;
};

TEST_F(FabricFile, ReadsUnitsOfTheTradeIntoSi) {
  const auto loaded = read(cloth);
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.at(0));
  const Fabric& fabric = *loaded.value;
  EXPECT_EQ(fabric.name, "cloth");
  EXPECT_NEAR(fabric.area_density, .4069, 1e-4);  // 12 oz denim
  EXPECT_NEAR(fabric.stretch_warp, 98.0665, 1e-9);
  EXPECT_NEAR(fabric.stretch_weft, 800, 1e-9);
  EXPECT_NEAR(fabric.bend_warp, 9.80665e-6, 1e-12);
  EXPECT_NEAR(fabric.bend_weft, 6e-6, 1e-12);
  EXPECT_NEAR(fabric.thickness, .3e-3, 1e-12);
  EXPECT_NEAR(fabric.most_stretch, .08, 1e-12);
  EXPECT_EQ(fabric.friction, .4);
}

TEST_F(FabricFile, ComplaintsNameTheLineAndTheUnits) {
  const Finding bare = first_error("\"50 N/m\"", "50");
  EXPECT_EQ(bare.code, "fabric.bad-value");
  EXPECT_EQ(bare.place, file_.filename().string() + ":6");
  EXPECT_NE(bare.remedy.find("N/cm"), std::string::npos) << bare.remedy;
  EXPECT_EQ(first_error("12 oz/yd^2", "12 oz").code, "fabric.bad-value");
  EXPECT_EQ(first_error("12 oz/yd^2", "heavy").code, "fabric.bad-value");
  EXPECT_EQ(first_error("friction = 0.4", "friction = \"0.4\"").code, "fabric.bad-value");
  EXPECT_EQ(first_error("0.3 mm", "0.3 m").code, "fabric.out-of-range");
  EXPECT_EQ(first_error("\"10 N/m\"", "\"900 N/m\"").code, "fabric.unstable");
  EXPECT_EQ(first_error("shear", "sheer").code, "fabric.unknown-key");
  EXPECT_EQ(first_error("friction = 0.4\n", "").code, "fabric.missing");
  EXPECT_EQ(first_error("\"8 %\"", "\"8 %").code, "toml.syntax");
  EXPECT_EQ(read_fabric("/nonexistent/cloth.toml").report.findings.at(0).fault, Fault::missing);
}

}  // namespace
}  // namespace toile
