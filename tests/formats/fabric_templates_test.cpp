#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "formats/formats.h"

namespace toile {
namespace {

constexpr double gravity = 9.80665;

class FabricTemplate : public testing::TestWithParam<std::filesystem::path> {};

std::vector<std::filesystem::path> templates() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

TEST_P(FabricTemplate, ReadsAndIsAClothThatCanExist) {
  const auto loaded = read_fabric(GetParam());
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.at(0));
  const Fabric& cloth = *loaded.value;
  EXPECT_GT(cloth.source.size(), 40u) << "say where the figures come from";
  EXPECT_LT(cloth.stretch_cross * cloth.stretch_cross, cloth.stretch_warp * cloth.stretch_weft);
  // Poisson's ratios of what is pulled, Penava et al. 2014 and knits.
  EXPECT_LT(cloth.stretch_cross / cloth.stretch_weft, .5);
  EXPECT_LT(cloth.stretch_cross / cloth.stretch_warp, .5);
  // A bias strip gives more than one along the grain, or it would not be cut so.
  EXPECT_LT(cloth.shear, std::min(cloth.stretch_warp, cloth.stretch_weft));
  // Yarn fills 10 to 75 % of the thickness (fibres weigh 0.9 to 1.6 g/cm^3).
  EXPECT_GT(cloth.area_density / cloth.thickness, 100);
  EXPECT_LT(cloth.area_density / cloth.thickness, 1100);
  EXPECT_GE(cloth.friction, .2);
  EXPECT_LE(cloth.friction, .6);
}

// KES-FB2 prints .005 gf cm^2/cm for the thinnest silks to 2 for coatings and canvas; cantilever bending lengths of clothing
// run from 1 to 4 cm (SiroFAST; ASTM D1388).
TEST_P(FabricTemplate, BendsWithinPublishedRanges) {
  const Fabric cloth = *read_fabric(GetParam()).value;
  for (const double bend : {cloth.bend_warp, cloth.bend_weft}) {
    EXPECT_GE(bend / 98.0665e-6, .005);
    EXPECT_LE(bend / 98.0665e-6, 2);
    const double length = std::cbrt(bend / (cloth.area_density * gravity));
    EXPECT_GE(length, .01);
    EXPECT_LE(length, .04);
  }
  EXPECT_GE(cloth.shear / 56.187, .15);  // gf/(cm deg), KES-FB1
  EXPECT_LE(cloth.shear / 56.187, 5);
}

INSTANTIATE_TEST_SUITE_P(All, FabricTemplate, testing::ValuesIn(templates()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(FabricTemplates, AreTenAndMoreAndOrderedAsAHandWouldOrderThem) {
  EXPECT_GE(templates().size(), 10u);
  const auto cloth = [](const char* name) {
    return *read_fabric(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics" / (std::string(name) + ".toml")).value;
  };
  EXPECT_LT(cloth("jersey").stretch_warp, cloth("cotton_poplin").stretch_weft);
  EXPECT_LT(cloth("rib_knit").stretch_weft, cloth("interlock").stretch_weft);
  double before = 0;
  for (const char* name : {"silk_chiffon", "silk_charmeuse", "viscose_challis", "cotton_poplin", "wool_suiting", "denim",
                           "wool_coating", "cotton_duck"}) {
    EXPECT_GT(cloth(name).bend_warp, before) << name;
    before = cloth(name).bend_warp;
  }
  // Means of men's winter suitings, Kawabata 1980: 10^-.8673 gf cm^2/cm, 10^-.0662 gf/(cm deg), 26.4 mg/cm^2.
  const Fabric suiting = cloth("wool_suiting");
  EXPECT_NEAR((suiting.bend_warp + suiting.bend_weft) / 2, std::pow(10, -.8673) * 98.0665e-6, 1e-6);
  EXPECT_NEAR(suiting.shear, std::pow(10, -.0662) * 56.187, 1);
  EXPECT_NEAR(suiting.area_density, .264, .01);
  EXPECT_NEAR(cloth("silk_charmeuse").area_density, 19 * 4.340e-3, 1e-9);
}

}  // namespace
}  // namespace toile
