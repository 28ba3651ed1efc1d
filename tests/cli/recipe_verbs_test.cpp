// edit, grade and bench as a user runs them, on a coarse mesh.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace toile::test {
namespace {

class RecipeVerbs : public testing::Test {
 protected:
  void SetUp() override {
    here_.write("shorter.toml",
                "name = \"shorter\"\n[pattern]\nfile = \"" TOILE_SOURCE_DIR
                "/samples/gored_skirt/gored_skirt.dxf\"\n[body]\nsize = \"38\"\n[fabric]\nname = \"jersey\"\n"
                "[drape]\nedge_length = \"30 mm\"\ntolerance = 1e-3\n[[edit]]\noperation = \"length\"\nby = \"-5 cm\"\n"
                "[adjust]\nsteps = 2\n");
  }
  Ended verb(const std::string& name, std::vector<std::string> more) const {
    std::vector<std::string> arguments{name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), {"--out", (here_ / "out").string()});
    return run_program(arguments);
  }
  std::string recipe() const { return (here_ / "shorter.toml").string(); }
  nlohmann::json json(const std::string& file) const { return nlohmann::json::parse(contents(here_ / ("out/" + file))); }

  Workplace here_;
};

TEST_F(RecipeVerbs, EditWritesTheTargetAndWhatMoved) {
  const Ended ended = verb("edit", {recipe()});
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("1 edits"), std::string::npos) << ended.out;
  const auto said = json("summary.json");
  EXPECT_FALSE(said.contains("adjusted"));
  std::set<std::string> codes;
  for (const auto& finding : said["findings"]) codes.insert(finding["code"].get<std::string>());
  EXPECT_TRUE(codes.count("edit.moved"));
  for (const char* file : {"source.obj", "target.obj", "target.png", "report.html"})
    EXPECT_TRUE(std::filesystem::exists(here_ / ("out/" + std::string(file)))) << file;
  EXPECT_FALSE(std::filesystem::exists(here_ / "out/shorter.dxf"));
}

TEST_F(RecipeVerbs, GradeMakesEverySizeWithItsCertificate) {
  const Ended ended = verb("grade", {recipe(), "--sizes", "38, 40"});
  EXPECT_TRUE(ended.status == 0 || ended.status == 10) << ended.err;  // so coarse a mesh may miss a bound
  EXPECT_NE(ended.out.find("2 sizes"), std::string::npos) << ended.out;
  for (const std::string size : {"38", "40"}) {
    const auto said = json(size + "/summary.json");
    EXPECT_EQ(said["mannequin"]["name"], "women " + size);
    EXPECT_LT(said["adjusted"]["seam_mismatch_mm"].get<double>(), 1);
    EXPECT_LT(said["adjusted"]["hausdorff_percent"].get<double>(), 2);
    ASSERT_GE(said["certificate"].size(), 5u);
    const std::string dxf = contents(here_ / ("out/" + size + "/shorter.dxf")),
                      svg = contents(here_ / ("out/" + size + "/shorter.svg"));
    const std::string measured = said["certificate"][1];
    EXPECT_NE(dxf.find("Annotation: " + measured), std::string::npos);
    EXPECT_NE(svg.find("Re-drape of this pattern"), std::string::npos);
    const std::vector<std::string> files = said["files"];
    for (const char* sheet : {"shorter.pdf", "shorter_a4.pdf"}) {
      EXPECT_EQ(contents(here_ / ("out/" + size + "/" + sheet)).compare(0, 5, "%PDF-"), 0) << sheet;
      EXPECT_NE(std::find(files.begin(), files.end(), sheet), files.end()) << sheet;
    }
    EXPECT_NE(dxf.find(said["inputs"]["jersey.toml"].get<std::string>().substr(0, 12)), std::string::npos);
  }
  const std::string page = contents(here_ / "out/grading.html");
  EXPECT_NE(page.find("40/report.html"), std::string::npos);
  for (const char* file : {"shorter.nest.dxf", "shorter.base.dxf", "shorter.rul"}) {
    EXPECT_TRUE(std::filesystem::exists(here_ / ("out/" + std::string(file)))) << file;
    EXPECT_NE(page.find(file), std::string::npos) << file;
  }
}

TEST_F(RecipeVerbs, GradeRefusesSizesThatAreNotThere) {
  const Ended ended = verb("grade", {recipe(), "--sizes", "38,39"});
  EXPECT_EQ(ended.status, 66) << ended.err;
  EXPECT_NE(ended.err.find("Sizes there are"), std::string::npos) << ended.err;
  EXPECT_EQ(verb("grade", {recipe(), "--sizes", "38,,40"}).status, 65);
  EXPECT_EQ(here_.everything(), (std::set<std::string>{"shorter.toml"}));
}

TEST_F(RecipeVerbs, BenchNamesItsRows) {
  const Ended ended = verb("bench", {"table1", "--rows", "Fig. 99"});
  EXPECT_EQ(ended.status, 65);
  EXPECT_NE(ended.err.find("Fig. 2"), std::string::npos) << ended.err;
  EXPECT_EQ(verb("bench", {"table2"}).status, 64);
}

}  // namespace
}  // namespace toile::test
