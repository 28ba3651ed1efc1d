#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/run.h"

namespace toile {
namespace {

namespace fs = std::filesystem;

struct Case {
  const char* pattern;
  const char* by;
  double most_hausdorff;  // percent of the height, as adjusted
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.pattern << " " << c.by; }

class GarmentCodeGarment : public testing::TestWithParam<Case> {};

// From the GarmentCode file to the cut sheet, as a user runs it.
TEST_P(GarmentCodeGarment, HemMovedOnTheScannedBody) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "takes minutes under a sanitizer";
#endif
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  std::string name = (fs::temp_directory_path() / "toile_skirt_XXXXXX").string();
  ASSERT_TRUE(::mkdtemp(name.data()));
  const fs::path here = name;
  const fs::path from = corpus;
  std::ofstream(here / "skirt.toml") << "[pattern]\nfile = \""
                                     << (from / "patterns/garmentcode/mh_f38" / GetParam().pattern).string() << ".json\"\n"
                                     << "[body]\nfile = \"" << (from / "bodies/f38_168_A45_wrap.obj").string() << "\"\n"
                                     << "skeleton = \"" << (from / "bodies/f38_168_A45.skeleton.json").string() << "\"\n"
                                     << "[fabric]\nname = \"jersey\"\n[drape]\nedge_length = \"15 mm\"\n"
                                     << "[[edit]]\noperation = \"length\"\nloop = \"hem\"\nby = \"" << GetParam().by << "\"\n";
  const fs::path out = here / "out";
  const int code = run_recipe({.recipe = here / "skirt.toml", .out = out, .quiet = true, .progress = ProgressStyle::none});
  EXPECT_TRUE(code == 0 || code == 10) << code;

  const auto summary = nlohmann::json::parse(std::ifstream(out / "summary.json"));
  const auto number = [&](const char* pointer) { return summary.at(nlohmann::json::json_pointer(pointer)).get<double>(); };
  const bool settled = summary.at("drape").at("settled");
  EXPECT_TRUE(settled);
  EXPECT_LE(number("/drape/max_penetration_mm"), .5);
  EXPECT_LE(number("/adjusted/seam_mismatch_mm"), 1);
  EXPECT_GE(number("/adjusted/stretch"), .99);
  EXPECT_LE(number("/adjusted/hausdorff_percent"), GetParam().most_hausdorff);
  EXPECT_GT(number("/flattened/hausdorff_percent"), 0);
  EXPECT_LE(number("/adjusted/hausdorff_percent"), number("/flattened/hausdorff_percent"));
  ASSERT_EQ(summary.at("inputs").size(), 5u);  // recipe, pattern, body, skeleton, fabric
  for (const auto& hash : summary.at("inputs")) EXPECT_EQ(hash.get<std::string>().size(), 64u);
  for (const auto& file : summary.at("files")) EXPECT_TRUE(fs::is_regular_file(out / file.get<std::string>())) << file;
  for (const char* file :
       {"skirt.dxf", "skirt.seams.toml", "skirt.svg", "source.obj", "target.obj", "redrape.obj", "summary.json"})
    EXPECT_TRUE(fs::is_regular_file(out / file)) << file;
  for (const char* figure : {"/flattened/hausdorff_percent", "/adjusted/hausdorff_percent", "/adjusted/mean_mm",
                             "/adjusted/seam_mismatch_mm", "/drape/max_penetration_mm", "/drape/seconds", "/adjusted/seconds"})
    std::printf("%s %s %s = %g\n", GetParam().pattern, GetParam().by, figure, number(figure));
  std::error_code ignored;
  fs::remove_all(here, ignored);
}

// The aim is 0.5 % everywhere. The six-panel skirt is 2.4 m round the hem; 8 cm more of it hang a little nearer to the legs
// than the folds carried straight on: there the bound is what is reached.
INSTANTIATE_TEST_SUITE_P(Cases, GarmentCodeGarment,
                         testing::Values(Case{"skirt_2panel", "-8 cm", .5}, Case{"skirt_2panel", "8 cm", .5},
                                         Case{"skirt_6panel", "-8 cm", .5}, Case{"skirt_6panel", "8 cm", .75},
                                         Case{"pants_straight", "-6 cm", .6}, Case{"dress_fitted_pencil_sleeve", "-5 cm", .6}));

}  // namespace
}  // namespace toile
