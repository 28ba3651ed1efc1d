#include "cli/inputs.h"

#include <gtest/gtest.h>

#include "cli/program.h"
#include "cli/recipe_file.h"
#include "formats/sha256/sha256.h"

namespace toile::test {
namespace {

class Inputs : public testing::Test {
 protected:
  Inputs() {
    here_.write("job.toml",
                "[pattern]\nfile = \"skirt.dxf\"\n[body]\nfile = \"me_wrap.obj\"\n[fabric]\nfile = \"mine/wool.toml\"\n");
    here_.write("skirt.dxf", "a pattern");
    here_.write("me_wrap.obj", "a body");
    std::filesystem::create_directory(here_ / "mine");
    here_.write("mine/wool.toml", "a fabric");
  }
  std::vector<InputHash> read() const {
    return hashes(input_files(here_ / "job.toml", read_recipe(here_ / "job.toml").value.value()));
  }

  Workplace here_;
};

TEST_F(Inputs, AreWhatTheRecipeNamesAndWhatLiesBesideIt) {
  EXPECT_EQ(by_name(read()), (std::map<std::string, std::string>{{"job.toml", sha256(contents(here_ / "job.toml"))},
                                                                 {"skirt.dxf", sha256("a pattern")},
                                                                 {"me_wrap.obj", sha256("a body")},
                                                                 {"wool.toml", sha256("a fabric")}}));
  here_.write("skirt.seams.toml", "seams");
  here_.write("me.skeleton.json", "bones");
  const std::vector<InputHash> all = read();
  ASSERT_EQ(all.size(), 6u);
  const auto named = by_name(all);
  EXPECT_EQ(named.at("skirt.seams.toml"), sha256("seams"));
  EXPECT_EQ(named.at("me.skeleton.json"), sha256("bones"));
}

TEST_F(Inputs, AChartIsAnInputLikeABody) {
  here_.write("job.toml", "[pattern]\nfile = \"skirt.dxf\"\n[body]\nsize = \"38\"\n[fabric]\nname = \"denim\"\n");
  const auto named = by_name(read());
  const std::filesystem::path templates = std::filesystem::path(TOILE_SOURCE_DIR) / "templates";
  EXPECT_EQ(named.at("women.csv"), sha256(contents(templates / "mannequins" / "women.csv")));
  EXPECT_EQ(named.at("denim.toml"), sha256(contents(templates / "fabrics" / "denim.toml")));
}

TEST_F(Inputs, OfOneNameAreToldApart) {
  here_.write("skirt.seams.toml", "seams");
  here_.write("mine/skirt.seams.toml", "a fabric");
  here_.write("job.toml",
              "[pattern]\nfile = \"skirt.dxf\"\n[body]\nfile = \"me_wrap.obj\"\n[fabric]\nfile = \"mine/skirt.seams.toml\"\n");
  const auto named = by_name(read());
  EXPECT_EQ(named.size(), 5u);
  EXPECT_EQ(named.at((here_ / "skirt.seams.toml").string()), sha256("seams"));
  EXPECT_EQ(named.at((here_ / "mine/skirt.seams.toml").string()), sha256("a fabric"));
}

TEST_F(Inputs, InShortTellVersionsApart) {
  here_.write("skirt.dxf", "abc");
  EXPECT_EQ(in_short(read().at(1)), "skirt.dxf (SHA-256 ba7816bf8f01)");
}

TEST_F(Inputs, ThatCannotBeReadAreNamed) {
  std::filesystem::remove(here_ / "me_wrap.obj");
  EXPECT_THROW(read(), BadInput);
}

}  // namespace
}  // namespace toile::test
