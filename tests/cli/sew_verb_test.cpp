#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "formats/formats.h"

namespace toile {
namespace {

using test::run_program;
using test::Workplace;

// The sample skirt without its sidecar.
std::string skirt_alone(const Workplace& place) {
  std::filesystem::copy(std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf", place / "skirt.dxf");
  return (place / "skirt.dxf").string();
}

TEST(SewVerb, WritesASidecarThatReadsBackWithACommentForEachSeam) {
  const Workplace place;
  const std::string pattern = skirt_alone(place), out = (place / "skirt.seams.toml").string();
  const auto ended = run_program({"sew", pattern, "-o", out});
  ASSERT_EQ(ended.status, 0) << ended.err;
  const Pattern read = value_or_throw(read_pattern(pattern));
  EXPECT_FALSE(read.seams.empty());
  const std::string text = test::contents(out);
  std::size_t comments = 0;
  for (std::size_t at = 0; (at = text.find(" %, ", at)) != std::string::npos; ++at) ++comments;
  EXPECT_GE(comments, read.seams.size());
}

TEST(SewVerb, DoesNotReplaceAFileUnasked) {
  const Workplace place;
  const std::string pattern = skirt_alone(place);
  place.write("skirt.seams.toml", "");
  const auto ended = run_program({"sew", pattern, "-o", (place / "skirt.seams.toml").string()});
  EXPECT_EQ(ended.status, 73);
  EXPECT_EQ(test::contents(place / "skirt.seams.toml"), "");
}

// A FreeSewing skirt with darts, a vent and a band, of which nothing says how it is sewn, from its SVG to a verified cut sheet.
TEST(SewVerb, RunsASkirtThatComesWithoutSeams) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "no corpus";
  const Workplace place;
  const std::string svg = "penelope_cisFemaleAdult38_sa10.svg";
  std::filesystem::copy(std::filesystem::path(corpus) / "patterns/freesewing" / svg, place / svg);
  place.write("shorter.toml",
              "[pattern]\nfile = \"" + svg +
                  "\"\n[body]\nchart = \"women\"\nsize = \"38\"\n[fabric]\nname = \"cotton_poplin\"\n"
                  "[drape]\nedge_length = \"30 mm\"\n[[edit]]\noperation = \"length\"\nloop = \"hem\"\nby = \"-8 cm\"\n"
                  "[adjust]\nsteps = 1\n");
  const auto ended = run_program({"run", (place / "shorter.toml").string(), "--out", (place / "out").string()});
  ASSERT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.err.find("seams.proposed"), std::string::npos);
  const auto summary = nlohmann::json::parse(test::contents(place / "out/summary.json"));
  EXPECT_EQ(summary["ok"], true);
  bool sheet = false;
  for (const std::string& name : place.everything())
    sheet = sheet || (name.rfind("out/", 0) == 0 && name.find(".dxf") != std::string::npos);
  EXPECT_TRUE(sheet);
}

TEST(CheckVerb, PassesTheSampleAndPrintsBothUnits) {
  const auto ended = run_program({"check", std::string(TOILE_SOURCE_DIR) + "/samples/gored_skirt/gored_skirt.dxf"});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  EXPECT_NE(ended.out.find(" mm ("), std::string::npos);
  EXPECT_NE(ended.out.find(" in)"), std::string::npos);
}

TEST(CheckVerb, FailsSeamsThatAreApartAndSaysSoInJson) {
  const Workplace place;
  const std::string pattern = skirt_alone(place);
  place.write("other.toml", "[[seam]]\nname = \"odd\"\na = \"GORE:1.e0\"\nb = \"WAISTBAND.e0\"\n");
  const auto ended = run_program({"check", pattern, "--seams", (place / "other.toml").string(), "--json"});
  EXPECT_EQ(ended.status, 10) << ended.out << ended.err;
  const auto json = nlohmann::json::parse(ended.out);
  EXPECT_EQ(json["failed"], 1);
  EXPECT_EQ(json["seams"][0]["verdict"], "fail");
}

}  // namespace
}  // namespace toile
