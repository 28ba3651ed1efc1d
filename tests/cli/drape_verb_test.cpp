#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "formats/html/base64.h"

namespace toile::test {
namespace {

class DrapeVerb : public testing::Test {
 protected:
  // The sample skirt on a coarse mesh.
  Ended drape(const std::string& out, std::vector<std::string> more = {}, const std::string& cue = {}) const {
    const auto skirt = std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "gored_skirt" / "gored_skirt.dxf";
    std::vector<std::string> arguments{"drape", skirt.string(), "--edge-length", "30 mm", "--out", (here_ / out).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments, cue);
  }
  Ended drape_too_high(const std::vector<std::string>& more) const {
    const auto skirt = std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "gored_skirt";
    std::string seams = contents(skirt / "gored_skirt.seams.toml");
    const std::string place = "drop = \"2 cm\", around = true";
    seams.replace(seams.find(place), place.size(), "drop = \"-75 cm\", around = true");
    here_.write("high.seams.toml", seams);
    std::vector<std::string> arguments{"drape",         (skirt / "gored_skirt.dxf").string(),
                                       "--seams",       (here_ / "high.seams.toml").string(),
                                       "--edge-length", "80 mm",
                                       "--out",         (here_ / "out").string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  nlohmann::json summary(const std::string& out) const {
    return nlohmann::json::parse(contents(here_ / (out + "/summary.json")));
  }

  Workplace here_;
};

TEST_F(DrapeVerb, WritesWhatHangsAndSaysHow) {
  const Ended ended = drape("out");
  EXPECT_EQ(ended.status, 0) << ended.err;
  EXPECT_NE(ended.out.find("settled"), std::string::npos) << ended.out;
  const auto said = summary("out");
  EXPECT_EQ(said["schema"], 1);
  EXPECT_TRUE(said["drape"]["settled"]);
  EXPECT_LE(said["drape"]["residual"].get<double>(), 1e-3);
  EXPECT_EQ(said["drape"]["self_intersections"], 0);
  EXPECT_EQ(said["drape"]["inverted_triangles"], 0);
  EXPECT_TRUE(said["drape"]["links_ok"]);
  EXPECT_LE(said["drape"]["max_penetration_mm"].get<double>(), .5);
  EXPECT_LE(said["drape"]["slipped_mm"].get<double>(), 30);
  EXPECT_FALSE(said.contains("adjusted"));
  EXPECT_EQ(said["inputs"].size(), 4u);  // pattern, seams, size chart, fabric
  for (const auto& file : said["files"])
    EXPECT_TRUE(std::filesystem::is_regular_file(here_ / ("out/" + file.get<std::string>())));
}

TEST_F(DrapeVerb, ThePageShowsEveryPictureAndTheGirths) {
  ASSERT_EQ(drape("out").status, 0);
  const std::string page = contents(here_ / "out/report.html");
  for (const char* file : {"drape", "stretch_warp", "stretch_weft", "stretch_bias", "ease", "pressure"})
    EXPECT_NE(page.find(base64(contents(here_ / ("out/" + std::string(file) + ".png")))), std::string::npos) << file;
  const auto said = summary("out");
  EXPECT_NE(page.find(said["verdict"].get<std::string>()), std::string::npos);
  ASSERT_FALSE(said["girths"].empty());
  for (const auto& row : said["girths"])
    EXPECT_NE(page.find("<td>" + row["name"].get<std::string>() + "</td>"), std::string::npos);
  for (const char* of_runs : {"<h2>Recipe", "<h2>Seams", "<h2>Steps", "<h2>First drape"})
    EXPECT_EQ(page.find(of_runs), std::string::npos) << of_runs;
}

// The sample skirt with a second skirt of the same gores over it in the waist seam.
TEST_F(DrapeVerb, ASecondSkirtInTheWaistSeamHangsOverTheFirst) {
  const auto sample = std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "gored_skirt";
  std::string dxf = contents(sample / "gored_skirt.dxf"), seams = contents(sample / "gored_skirt.seams.toml");
  const auto doubled = [&](const std::string& from, const std::string& to) {
    const std::size_t name = dxf.find("GORE_38", dxf.find(from));
    const std::size_t begin = dxf.rfind("  0\n" + from, name), end = dxf.find("  0\n" + to, name);
    std::string copy = dxf.substr(begin, end - begin);
    for (std::size_t at = 0; (at = copy.find("GORE", at)) != std::string::npos;) copy.replace(at, 4, "OUTER");
    dxf.insert(end, copy);
  };
  doubled("INSERT", "ENDSEC");
  doubled("BLOCK\n", "ENDSEC");
  here_.write("double.dxf", dxf);
  const std::size_t piece = seams.find("[[piece]]"), band = seams.find("[[piece]]", piece + 1);
  std::string outer = seams.substr(piece, band - piece);
  outer.replace(outer.find("GORE"), 4, "OUTER");
  here_.write("double.seams.toml", seams + "\n" + outer +
                                       "[[seam]]\nring = \"OUTER\"\nfrom = \"right\"\nto = \"left\"\n"
                                       "[[seam]]\nalong = \"WAISTBAND.bottom\"\neach = \"OUTER.top\"\n");
  const Ended ended =
      run_program({"drape", (here_ / "double.dxf").string(), "--edge-length", "30 mm", "--out", (here_ / "out").string()});
  EXPECT_EQ(ended.status, 0) << ended.out << ended.err;
  const auto said = summary("out");
  EXPECT_TRUE(said["drape"]["settled"]);
  EXPECT_EQ(said["drape"]["self_intersections"], 0);
  EXPECT_TRUE(said["drape"]["links_ok"]);
}

// Gores put where the head is cannot be sewn round the trunk.
TEST_F(DrapeVerb, DressingThatGetsStuckIsShown) {
  const Ended ended = drape_too_high({"--time-limit", "0.1"});
  EXPECT_TRUE(ended.status == 10 || ended.status == 11) << ended.err;
  EXPECT_NE(ended.out.find("did not come together (see stuck.png)"), std::string::npos) << ended.out;
  const auto said = summary("out");
  bool named = false;
  for (const auto& finding : said["findings"])
    named = named || finding["remedy"].get<std::string>().find("stuck.png") != std::string::npos;
  EXPECT_TRUE(named);
  EXPECT_TRUE(std::filesystem::is_regular_file(here_ / "out/stuck.obj"));
  EXPECT_NE(contents(here_ / "out/report.html").find(base64(contents(here_ / "out/stuck.png"))), std::string::npos);
}

// What fails after that, likely because of it, still leaves the picture.
TEST_F(DrapeVerb, DressingThatGetsStuckIsShownAlsoWhenTheSimulatorFails) {
  here_.write("fails.toml",
              "name = \"fails\"\nsummary = \"\"\nprogram = \"/bin/false\"\ncommand = [\"{program}\"]\ntime_limit = 9\n");
  const Ended ended = drape_too_high({"--simulator", (here_ / "fails.toml").string()});
  EXPECT_NE(ended.err.find("simulator.external-failed"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("Where: stuck.png"), std::string::npos) << ended.err;
  EXPECT_EQ(here_.everything(),
            (std::set<std::string>{"fails.toml", "high.seams.toml", "out", "out/body.obj", "out/stuck.obj", "out/stuck.png"}));
}

TEST_F(DrapeVerb, TheSameBytesTwice) {
  ASSERT_EQ(drape("once").status, 0);
  ASSERT_EQ(drape("again").status, 0);
  EXPECT_EQ(contents(here_ / "once/drape.obj"), contents(here_ / "again/drape.obj"));
}

TEST_F(DrapeVerb, OutOfTimeLeavesTheBestStateToGoOnFrom) {
  const Ended cut_short = drape("early", {"--time-limit", "0.000001", "--quiet"});
  EXPECT_EQ(cut_short.status, 11) << cut_short.err;
  EXPECT_NE(cut_short.err.find("--go-on"), std::string::npos);
  EXPECT_FALSE(summary("early")["drape"]["settled"]);
  const Ended later = drape("late", {"--go-on", (here_ / "early/drape.obj").string()});
  EXPECT_EQ(later.status, 0) << later.err;
  EXPECT_TRUE(summary("late")["drape"]["settled"]);
}

TEST_F(DrapeVerb, InterruptedLeavesTheBestStateToo) {
  const Ended cut_short = drape("early", {"--progress", "json", "--tolerance", "1e-12"}, "residual");
  EXPECT_EQ(cut_short.status, 75) << cut_short.err;
  EXPECT_FALSE(summary("early")["drape"]["settled"]);
  EXPECT_TRUE(std::filesystem::is_regular_file(here_ / "early/drape.obj"));
}

TEST_F(DrapeVerb, InterruptedBeforeThatLeavesNothing) {
  const Ended cut_short = drape("early", {"--progress", "json"}, "sewing");
  EXPECT_EQ(cut_short.status, 75) << cut_short.err;
  EXPECT_TRUE(here_.everything().empty());
}

TEST_F(DrapeVerb, RefusesADrapeOfAnotherGarment) {
  here_.write("other.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Ended refused = drape("out", {"--go-on", (here_ / "other.obj").string()});
  EXPECT_EQ(refused.status, 65);
  EXPECT_NE(refused.err.find("drape.other-garment"), std::string::npos) << refused.err;
  EXPECT_EQ(here_.everything().size(), 1u);
}

TEST_F(DrapeVerb, RefusesALengthWithoutItsUnit) {
  const Ended refused = drape("out", {"--edge-length", "30"});
  EXPECT_EQ(refused.status, 64) << "given twice";
  const Ended bare = run_program({"drape", "x.json", "--edge-length", "30", "--out", (here_ / "out").string()});
  EXPECT_EQ(bare.status, 65);
  EXPECT_NE(bare.err.find("--edge-length: error[option.no-length]"), std::string::npos) << bare.err;
}

}  // namespace
}  // namespace toile::test
