#include "cli/recipe_file.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cli/program.h"

namespace toile::test {
namespace {

const std::string least = "[pattern]\nfile = \"skirt.dxf\"\n[body]\nsize = \"40\"\n[fabric]\nname = \"denim\"\n";

class RecipeFile : public testing::Test {
 protected:
  Loaded<Recipe> read(const std::string& text) const {
    here_.write("dress.toml", text);
    return read_recipe(here_ / "dress.toml");
  }
  // The one error of a recipe.
  Finding error_of(const std::string& text) const {
    const Loaded<Recipe> loaded = read(text);
    EXPECT_FALSE(loaded.value) << text;
    EXPECT_EQ(loaded.report.findings.size(), 1u) << text;
    return loaded.report.findings.empty() ? Finding{} : loaded.report.findings.front();
  }
  std::string at_line(int line) const { return (here_ / "dress.toml").string() + ":" + std::to_string(line); }

  Workplace here_;
};

TEST_F(RecipeFile, ASimulatorOfOnesOwnIsBesideTheRecipe) {
  const auto simulator = [&](const std::string& written) {
    return read(least + "[drape]\nsimulator = \"" + written + "\"\n").value.value().drape.simulator;
  };
  EXPECT_EQ(simulator("mine/program.toml"), (here_ / "mine/program.toml").string());
  EXPECT_EQ(simulator("/abs/program.toml"), "/abs/program.toml");
  EXPECT_EQ(simulator("external:blender"), "external:blender");
  EXPECT_EQ(simulator("external:odd.toml"), "external:odd.toml");
  EXPECT_EQ(simulator("mass-spring"), "mass-spring");
}

TEST_F(RecipeFile, EveryPartIsRead) {
  const Loaded<Recipe> loaded = read(R"(name = "a dress"
[pattern]
file = "patterns/dress.dxf"
seams = "dress_sewn.toml"
units = "cm"
[body]
file = "/bodies/me.obj"
skeleton = "me.json"
[fabric]
file = "wool.toml"
[drape]
simulator = "fem-projected"
edge_length = "1.5 cm"
tolerance = 1e-5
[[edit]]
operation = "length"
loop = "hem"
by = "-5 cm"
[[edit]]
operation = "length"
loop = ["cuff.L", "cuff.R"]
by = "2 cm"
release = 0.5
[adjust]
steps = 7
tolerance = 0.002
[cut]
allowance = "5/8 in"
hem = "4 cm"
width = "1.4 m"
gap = "20 mm"
)");
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.front());
  const Recipe& recipe = *loaded.value;
  const std::filesystem::path folder = (here_ / "dress.toml").parent_path();
  EXPECT_EQ(recipe.name, "a dress");
  EXPECT_EQ(recipe.pattern.file, folder / "patterns/dress.dxf");
  EXPECT_EQ(recipe.pattern.seams, folder / "dress_sewn.toml");
  ASSERT_TRUE(recipe.pattern.unit_in_metres);
  EXPECT_DOUBLE_EQ(*recipe.pattern.unit_in_metres, .01);
  EXPECT_EQ(recipe.body.file, "/bodies/me.obj");
  EXPECT_EQ(recipe.body.skeleton, folder / "me.json");
  EXPECT_EQ(recipe.fabric.file, folder / "wool.toml");
  EXPECT_EQ(recipe.drape.simulator, "fem-projected");
  EXPECT_DOUBLE_EQ(recipe.drape.edge_length, .015);
  EXPECT_DOUBLE_EQ(recipe.drape.tolerance, 1e-5);
  ASSERT_EQ(recipe.edits.size(), 2u);
  EXPECT_EQ(recipe.edits[0].operation, "length");
  EXPECT_EQ(recipe.edits[0].arguments, (EditArguments{{"by", "-5 cm"}, {"loop", "hem"}}));
  EXPECT_EQ(recipe.edits[0].place, at_line(15));
  EXPECT_EQ(recipe.edits[1].arguments, (EditArguments{{"by", "2 cm"}, {"loop", "cuff.L,cuff.R"}, {"release", "0.5"}}));
  EXPECT_EQ(recipe.adjust.steps, 7);
  EXPECT_DOUBLE_EQ(recipe.adjust.tolerance, .002);
  EXPECT_DOUBLE_EQ(recipe.cut.allowances.allowance, .625 * .0254);
  EXPECT_DOUBLE_EQ(recipe.cut.allowances.hem, .04);
  EXPECT_DOUBLE_EQ(recipe.cut.width, 1.4);
  EXPECT_DOUBLE_EQ(recipe.cut.gap, .02);
}

TEST_F(RecipeFile, WhatIsNotSaidIsTheDefault) {
  const Loaded<Recipe> loaded = read(least);
  ASSERT_TRUE(loaded.value);
  const Recipe& recipe = *loaded.value;
  const Recipe fresh;
  EXPECT_EQ(recipe.name, "dress");
  EXPECT_FALSE(recipe.pattern.seams);
  EXPECT_FALSE(recipe.pattern.unit_in_metres);
  EXPECT_EQ(recipe.body.chart, "women");
  EXPECT_EQ(recipe.body.size, "40");
  EXPECT_TRUE(recipe.body.file.empty());
  EXPECT_EQ(recipe.fabric.name, "denim");
  EXPECT_EQ(recipe.drape.simulator, "fem");
  EXPECT_EQ(recipe.drape.edge_length, fresh.drape.edge_length);
  EXPECT_EQ(recipe.drape.tolerance, fresh.drape.tolerance);
  EXPECT_TRUE(recipe.edits.empty());
  EXPECT_EQ(recipe.adjust.steps, fresh.adjust.steps);
  EXPECT_EQ(recipe.cut.allowances.hem, fresh.cut.allowances.hem);
  EXPECT_EQ(recipe.cut.width, fresh.cut.width);
}

TEST_F(RecipeFile, ThePaperOfTheCutSheetIsOneThereIs) {
  const auto letter = read(least + "[print]\npaper = \"Letter\"\nmargin = \"1/4 in\"\noverlap = \"0 mm\"\n");
  ASSERT_TRUE(letter.value);
  EXPECT_EQ(letter.value->print.paper, "Letter");
  EXPECT_DOUBLE_EQ(letter.value->print.margin, .00635);
  EXPECT_EQ(letter.value->print.overlap, 0);
  const Finding no_paper = error_of(least + "[print]\npaper = \"a9\"\n");
  EXPECT_EQ(no_paper.code, "pdf.no-such-paper");
  EXPECT_EQ(no_paper.place, at_line(8));
  EXPECT_NE(no_paper.remedy.find("letter"), std::string::npos) << no_paper.remedy;
  EXPECT_EQ(error_of(least + "[print]\nmargin = \"1 mm\"\n").code, "pdf.margin");
}

TEST_F(RecipeFile, WindowsLineEndsAreNoTrouble) {
  std::string text;
  for (const char c : least) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(read(text).value);
}

TEST_F(RecipeFile, UnknownKeysAndPartsAreRefusedWithTheirLine) {
  for (const char* part : {"[pattern]", "[body]", "[fabric]"}) {
    std::string text = least;
    const std::size_t at = text.find(part) + std::string(part).size();
    text.insert(at, "\nfrobnicate = 1");
    const Finding error = error_of(text);
    EXPECT_EQ(error.code, "recipe.unknown-key");
    EXPECT_EQ(error.place, at_line(static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(at), '\n')) + 2));
  }
  for (const char* part : {"[drape]", "[adjust]", "[cut]", "[print]"})
    EXPECT_EQ(error_of(least + part + "\nfrobnicate = 1\n").place, at_line(8)) << part;
  const Finding misspelt = error_of(least + "[adjustment]\nsteps = 3\n");
  EXPECT_EQ(misspelt.code, "recipe.unknown-key");
  EXPECT_NE(misspelt.remedy.find("adjust,"), std::string::npos) << misspelt.remedy;
}

TEST_F(RecipeFile, PartsThatAreNeededAreAskedFor) {
  EXPECT_NE(error_of("[body]\nsize = \"40\"\n[fabric]\nname = \"denim\"\n").text.find("[pattern]"), std::string::npos);
  EXPECT_NE(error_of("[pattern]\nfile = \"a.dxf\"\n[fabric]\nname = \"denim\"\n").text.find("[body]"), std::string::npos);
  EXPECT_NE(error_of("[pattern]\nfile = \"a.dxf\"\n[body]\nsize = \"40\"\n").text.find("[fabric]"), std::string::npos);
  const Finding no_size = error_of("[pattern]\nfile = \"a.dxf\"\n[body]\n[fabric]\nname = \"denim\"\n");
  EXPECT_EQ(no_size.code, "recipe.missing-key");
  EXPECT_EQ(no_size.place, at_line(3));
  EXPECT_EQ(error_of(least + "[[edit]]\nby = \"1 cm\"\n").code, "recipe.missing-key");
}

TEST_F(RecipeFile, LengthsNeedTheirUnit) {
  for (const char* value : {"15", "0.015", "\"15\"", "\"15 furlongs\"", "\"mm\"", "true", "[\"15 mm\"]"}) {
    const Finding error = error_of(least + "[drape]\nedge_length = " + value + "\n");
    EXPECT_EQ(error.code, "recipe.no-unit") << value;
    EXPECT_EQ(error.place, at_line(8)) << value;
  }
}

TEST_F(RecipeFile, ValuesOutOfRangeAreRefused) {
  for (const char* line : {"[drape]\nedge_length = \"1 mm\"", "[drape]\nedge_length = \"-15 mm\"", "[drape]\ntolerance = 0",
                           "[drape]\ntolerance = nan", "[drape]\ntolerance = \"small\"", "[adjust]\nsteps = 0",
                           "[adjust]\nsteps = 51", "[cut]\nallowance = \"-1 cm\"", "[cut]\nwidth = \"5 cm\""}) {
    const Finding error = error_of(least + line + "\n");
    EXPECT_EQ(error.code, "recipe.out-of-range") << line;
    EXPECT_EQ(error.place, at_line(8)) << line;
  }
}

TEST_F(RecipeFile, StepsAreAWholeNumber) { EXPECT_EQ(error_of(least + "[adjust]\nsteps = 2.5\n").code, "recipe.out-of-range"); }

TEST_F(RecipeFile, WhatIsNeitherTextNorPartIsRefused) {
  EXPECT_EQ(error_of("name = 3\n" + least).code, "recipe.not-text");
  EXPECT_EQ(error_of("drape = 3\n" + least).code, "recipe.not-a-table");
  EXPECT_EQ(error_of("edit = \"length\"\n" + least).code, "recipe.not-a-list");
  EXPECT_EQ(error_of("edit = [1]\n" + least).code, "recipe.not-a-table");
  EXPECT_EQ(error_of(least + "[[edit]]\noperation = \"length\"\nloop = [1]\n").code, "recipe.not-text");
  EXPECT_EQ(error_of(least + "[[edit]]\noperation = \"length\"\nby = true\n").code, "recipe.not-text");
  EXPECT_EQ(error_of("[pattern\n" + least).code, "recipe.not-toml");
}

TEST_F(RecipeFile, UnknownUnitsOfThePatternAreRefused) {
  std::string text = least;
  text.insert(text.find("[body]"), "units = \"furlong\"\n");
  const Finding error = error_of(text);
  EXPECT_EQ(error.code, "recipe.unknown-unit");
  EXPECT_EQ(error.place, at_line(3));
}

TEST_F(RecipeFile, MissingFileIsMissing) {
  const Loaded<Recipe> loaded = read_recipe(here_ / "none.toml");
  EXPECT_FALSE(loaded.value);
  ASSERT_EQ(loaded.report.findings.size(), 1u);
  EXPECT_EQ(loaded.report.findings[0].fault, Fault::missing);
}

}  // namespace
}  // namespace toile::test
