#include <gtest/gtest.h>

#include <cstdio>
#include <regex>

#include "body/figure.h"
#include "cli/program.h"

namespace toile::test {
namespace {

const std::filesystem::path samples = std::filesystem::path(TOILE_SOURCE_DIR) / "samples" / "gored_skirt";

// `text` with the first `from` replaced; the test is wrong when there is none.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the sample has no '" + from + "'");
  return text.replace(at, from.size(), to);
}

std::string with_every(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

// A pattern a tenth as large that says nothing of its units: 71 mm, 71 cm or 71 in.
std::string shrunk_without_units(const std::string& dxf) {
  std::istringstream lines(with(dxf, "Units: METRIC", "Season: SUMMER"));
  std::string small, code, value;
  while (std::getline(lines, code) && std::getline(lines, value)) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.4f", std::atof(value.c_str()) / 10);
    const int group = std::atoi(code.c_str());
    small += code + "\n" + (group == 10 || group == 20 ? std::string(digits) : value) + "\n";
  }
  return small;
}

std::string figure_obj() {
  const Mannequin form = figure();
  std::ostringstream obj;
  for (Eigen::Index v = 0; v < form.positions.cols(); ++v)
    obj << "v " << form.positions(0, v) << " " << form.positions(1, v) << " " << form.positions(2, v) << "\n";
  for (Eigen::Index t = 0; t < form.triangles.cols(); ++t)
    obj << "f " << form.triangles(0, t) + 1 << " " << form.triangles(1, t) + 1 << " " << form.triangles(2, t) + 1 << "\n";
  return obj.str();
}

// The sample in a fresh folder, on a coarse mesh so that what fails late fails soon.
class BadInputs : public testing::Test {
 protected:
  BadInputs() {
    recipe_ = contents(samples / "shorten.toml");
    recipe_ = with(recipe_, "14 mm", "30 mm");
    recipe_ = with(recipe_, "tolerance = 1e-4", "tolerance = 1e-2");
    dxf_ = contents(samples / "gored_skirt.dxf");
    seams_ = contents(samples / "gored_skirt.seams.toml");
  }

  void lay_out() const {
    here_.write("job.toml", recipe_);
    here_.write("gored_skirt.dxf", dxf_);
    here_.write("gored_skirt.seams.toml", seams_);
  }

  Ended run(const std::string& out = "new/results") const {
    return run_program({"run", (here_ / "job.toml").string(), "--out", (here_ / out).string()});
  }

  // It ends with `status`, says `code` about `place` and what to do, and leaves the folder as it was.
  void refused(int status, const std::string& code, const std::string& place, const std::vector<std::string>& words = {},
               const std::string& out = "new/results") const {
    const auto before = here_.everything();
    const Ended ended = run(out);
    EXPECT_EQ(ended.status, status) << ended.err;
    const std::size_t at = ended.err.find("toile: ");
    ASSERT_NE(at, std::string::npos) << ended.err;
    const std::string said = ended.err.substr(at);
    EXPECT_NE(said.find("error[" + code + "]"), std::string::npos) << said;
    EXPECT_TRUE(std::regex_search(said, std::regex(place))) << "looked for " << place << " in\n" << said;
    // "place: error[code] what. remedy"
    EXPECT_TRUE(std::regex_search(said, std::regex(R"(error\[[a-z.-]+\] .+\. \S.+)"))) << "no remedy: " << said;
    for (const std::string& word : words) EXPECT_NE(said.find(word), std::string::npos) << word << " not in\n" << said;
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(here_.everything(), before);
  }

  Workplace here_;
  std::string recipe_, dxf_, seams_;
};

TEST_F(BadInputs, MissingRecipe) { refused(66, "file.missing", "job\\.toml"); }

TEST_F(BadInputs, RecipeThatIsNotToml) {
  recipe_ = with(recipe_, "[fabric]", "[fabric");
  lay_out();
  refused(65, "recipe.not-toml", "job\\.toml:1[0-9]:");
}

TEST_F(BadInputs, UnknownKeyIsNamedWithItsLineAndTheKeysThereAre) {
  recipe_ =
      "[drape]\nedge_lenght = \"3 cm\"\n[pattern]\nfile = \"gored_skirt.dxf\"\n[body]\nsize = \"38\"\n[fabric]\nname = "
      "\"jersey\"\n";
  lay_out();
  refused(65, "recipe.unknown-key", "job\\.toml:2:", {"edge_lenght", "edge_length", "simulator", "tolerance"});
}

TEST_F(BadInputs, LengthWithoutUnit) {
  recipe_ =
      "[drape]\nedge_length = 30\n[pattern]\nfile = \"gored_skirt.dxf\"\n[body]\nsize = \"38\"\n[fabric]\nname = \"jersey\"\n";
  lay_out();
  refused(65, "recipe.no-unit", "job\\.toml:2:", {"drape.edge_length", "1 cm"});
}

TEST_F(BadInputs, EditLengthWithoutUnit) {
  recipe_ = with(recipe_, "\"-10 cm\"", "-10");
  lay_out();
  refused(65, "edit.bad-length", "job\\.toml:[0-9]+", {"by", "cm"});
}

TEST_F(BadInputs, MissingPattern) {
  recipe_ = with(recipe_, "gored_skirt.dxf", "circle_skirt.dxf");
  lay_out();
  refused(66, "file.missing", "circle_skirt\\.dxf");
}

// Seams that can be told from the pieces are proposed (sew_verb_test); these pieces have no edge in common.
TEST_F(BadInputs, SeamsThatCannotBeTold) {
  recipe_ = with(recipe_, "gored_skirt.dxf", "odd.json");
  here_.write("job.toml", recipe_);
  here_.write("odd.json", R"({"properties": {"units_in_meter": 100}, "pattern": {"stitches": [], "panels": {
    "p": {"vertices": [[0,0],[40,0],[40,61],[0,52]], "translation": [0,100,20], "rotation": [0,0,0],
      "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,3]},{"endpoints":[3,0]}]},
    "q": {"vertices": [[0,0],[11,0],[5,17]], "translation": [0,100,-20], "rotation": [0,0,0],
      "edges": [{"endpoints":[0,1]},{"endpoints":[1,2]},{"endpoints":[2,0]}]}}}})");
  refused(12, "seams.unsure", "odd\\.json", {"nothing says what is sewn to what", "toile sew", "odd.seams.toml"});
}

TEST_F(BadInputs, TruncatedDxf) {
  dxf_ = dxf_.substr(0, dxf_.size() / 2);
  lay_out();
  refused(65, "dxf.truncated", "gored_skirt\\.dxf");
}

TEST_F(BadInputs, UnitsThatCannotBeTold) {
  dxf_ = shrunk_without_units(dxf_);
  lay_out();
  refused(12, "aama.units-ambiguous", "gored_skirt\\.dxf", {"units = \"mm\"", "inch"});
}

TEST_F(BadInputs, OpenOutline) {
  dxf_ = with_every(dxf_, "\n 70\n1\n", "\n 70\n0\n");
  lay_out();
  refused(65, "aama.open-outline", "gored_skirt\\.dxf:[0-9]+", {"WAISTBAND"});
}

TEST_F(BadInputs, SeamOfAnEdgeThatIsNotThere) {
  seams_ = with(seams_, "b = \"WAISTBAND.left\"", "b = \"WAISTBAND.leftt\"");
  lay_out();
  refused(65, "seam.unknown-edge", "gored_skirt\\.seams\\.toml:[0-9]+", {"leftt", "bottom", "right", "top", "left"});
}

TEST_F(BadInputs, UnknownFabric) {
  recipe_ = with(recipe_, "\"jersey\"", "\"gossamer\"");
  lay_out();
  refused(66, "template.missing", "gossamer\\.toml", {"denim", "jersey"});
}

TEST_F(BadInputs, UnknownSimulator) {
  recipe_ = with(recipe_, "\"fem\"", "\"clairvoyance\"");
  lay_out();
  refused(65, "simulator.unknown", "clairvoyance", {"fem"});
}

TEST_F(BadInputs, UnknownSize) {
  recipe_ = with(recipe_, "\"38\"", "\"39\"");
  lay_out();
  refused(66, "chart.unknown-size", "women\\.csv", {"39", "38", "40"});
}

TEST_F(BadInputs, UnknownSizeChart) {
  recipe_ = with(recipe_, "\"women\"", "\"martians\"");
  lay_out();
  refused(66, "template.missing", "martians\\.csv", {"men", "women"});
}

class BadBodies : public BadInputs {
 protected:
  BadBodies() { recipe_ = with(with(recipe_, "chart = \"women\"", "file = \"figure.obj\""), "size = \"38\"", ""); }
};

TEST_F(BadBodies, MissingBody) {
  lay_out();
  refused(66, "file.missing", "figure\\.obj");
}

TEST_F(BadBodies, BodyWithAHole) {
  lay_out();
  std::string obj = figure_obj();
  obj.erase(obj.find("f "), obj.find("\n", obj.find("f ")) - obj.find("f ") + 1);
  here_.write("figure.obj", obj);
  refused(65, "body.not-closed", "figure\\.obj");
}

TEST_F(BadBodies, BodyWithANotANumber) {
  lay_out();
  std::string obj = figure_obj();
  here_.write("figure.obj", "v nan 0 0" + obj.substr(obj.find("\n")));
  refused(65, "body.not-finite", "figure\\.obj:1");
}

TEST_F(BadInputs, EditThatSlipsOff) {
  recipe_ = with(recipe_, "\"-10 cm\"", "\"-55 cm\"");
  lay_out();
  refused(65, "edit.slips-off", "job\\.toml:[0-9]+", {"550 mm shorter", "shorten by less than"});
}

TEST_F(BadInputs, EditPastItsAnchor) {
  recipe_ = with(recipe_, "by = \"-10 cm\"", "anchor = \"hip\"\nby = \"-35 cm\"");
  lay_out();
  refused(65, "edit.past-anchor", "job\\.toml:[0-9]+", {"350 mm shorter", "at most"});
}

TEST_F(BadInputs, OutputBelowAFile) {
  lay_out();
  here_.write("occupied", "a file");
  refused(73, "output.cannot-create", "occupied/results", {}, "occupied/results");
  refused(73, "output.cannot-create", "occupied", {}, "occupied");
}

TEST_F(BadInputs, OutputFolderThatIsNotEmptyIsLeftAlone) {
  lay_out();
  std::filesystem::create_directory(here_ / "results");
  here_.write("results/notes.txt", "mine");
  refused(73, "output.exists", "results", {"--force"}, "results");
  EXPECT_EQ(contents(here_ / "results/notes.txt"), "mine");
}

TEST_F(BadInputs, ForcedIntoAFolderAFailureStillLeavesItAlone) {
  dxf_ = dxf_.substr(0, dxf_.size() / 2);
  lay_out();
  std::filesystem::create_directory(here_ / "results");
  here_.write("results/notes.txt", "mine");
  const auto before = here_.everything();
  EXPECT_EQ(run_program({"run", (here_ / "job.toml").string(), "--force", "--out", (here_ / "results").string()}).status, 65);
  EXPECT_EQ(here_.everything(), before);
}

TEST_F(BadInputs, AnEmptyFolderThatWasThereStaysThere) {
  dxf_ = "nonsense";
  lay_out();
  std::filesystem::create_directory(here_ / "results");
  refused(65, "dxf.not-dxf", "gored_skirt\\.dxf", {}, "results");
}

TEST_F(BadInputs, InterruptedItLeavesNothingBehind) {
  lay_out();
  const auto before = here_.everything();
  const Ended ended =
      run_program({"run", (here_ / "job.toml").string(), "--progress", "json", "--out", (here_ / "new/results").string()},
                  "\"stage\":\"drape\"");
  EXPECT_EQ(ended.status, 75) << ended.err;
  EXPECT_EQ(ended.out, "");
  EXPECT_EQ(here_.everything(), before);
}

TEST(CommandLine, WrongUseEndsWith64AndSaysWhereHelpIs) {
  const Workplace here;
  const std::string out = (here / "out").string();
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"sew"},
                                                    {"run"},
                                                    {"run", "job.toml"},
                                                    {"run", "job.toml", "--out", out, "--frobnicate"},
                                                    {"run", "job.toml", "--out", out, "--progress", "loud"},
                                                    {"run", "a.toml", "b.toml", "--out", out}}) {
    const Ended ended = run_program(arguments);
    EXPECT_EQ(ended.status, 64) << ended.err;
    EXPECT_NE(ended.err.find("--help"), std::string::npos) << ended.err;
    EXPECT_EQ(ended.out, "");
  }
  EXPECT_TRUE(here.everything().empty());
}

TEST(CommandLine, HelpSaysExitCodesAndEveryOption) {
  const Ended program = run_program({"--help"}), verb = run_program({"run", "--help"});
  EXPECT_EQ(program.status, 0);
  EXPECT_EQ(verb.status, 0);
  for (const Ended* help : {&program, &verb})
    for (const char* code : {" 0 ", " 1", "10 ", "11 ", "12 ", "64 ", "65 ", "66 ", "70 ", "73 ", "75 "})
      EXPECT_NE(help->out.find(code), std::string::npos) << code << "\n" << help->out;
  for (const char* option : {"--help", "--version", "run"}) EXPECT_NE(program.out.find(option), std::string::npos) << option;
  for (const char* option : {"--help", "--out", "--force", "--progress", "--quiet", "RECIPE.toml", "json", "none", "auto"})
    EXPECT_NE(verb.out.find(option), std::string::npos) << option;
}

TEST(CommandLine, VersionIsThatOfTheProject) {
  const Ended ended = run_program({"--version"});
  EXPECT_EQ(ended.status, 0);
  EXPECT_TRUE(std::regex_match(ended.out, std::regex(R"(toile \d+\.\d+\.\d+\n)"))) << ended.out;
}

}  // namespace
}  // namespace toile::test
