// A pattern in several sizes, written as a nest and as base with rules, and read back.

#include "cli/graded_files.h"

#include <gtest/gtest.h>

#include "cli/program.h"
#include "formats/aama_pieces.h"
#include "formats/formats.h"
#include "workbench/graded.h"

namespace toile {
namespace {

// Size 38 + 2 k: wider by 20 mm and longer by 6 mm a size, the hem deeper; its curves drawn with `segments` chords.
Pattern size_of(double k, int segments) {
  const double half = .18 + .01 * k, top = .09 + .006 * k, up = .6 + .006 * k;
  Piece front = drafted_piece("Ärmel", {{curve({-half, 0}, {half, 0}, -.012 - .001 * k, segments), 40e-3},
                                        {curve({half, 0}, {top, up}, -.01, segments), 15e-3},
                                        {{{top, up}, {-top, up}}, 10e-3},
                                        {curve({-top, up}, {-half, 0}, -.01, segments), 15e-3}});
  front.notches = {{"e1", .25, NotchKind::slit, 5e-3, 0}, {"e3", .5, NotchKind::v, 4e-3, 3e-3}};
  front.drill_holes = {{{.01, .3}, 3e-3}};
  front.grainline = Grainline{{0, .1}, {0, .5}};
  Piece other = band(.7 + .04 * k);
  other.name = "Aermel";
  Pattern pattern;
  pattern.name = "skirt";
  pattern.pieces = {front, other, disc()};
  return pattern;
}

PatternFile graded() {
  PatternFile file;
  file.sizes = {"36", "38", "40 tall"};
  file.graded = with_same_points({size_of(-1, 18), size_of(0, 31), size_of(1, 24)});
  for (std::size_t s = 0; s < 3; ++s) file.graded[s].sample_size = file.sizes[s];
  file.pattern = file.graded[1];
  return file;
}

class GradedFilesTest : public testing::Test {
 protected:
  GradedFilesTest() {
    const GradedFiles files = graded_files(graded(), "skirt", {});
    here_.write("nest.dxf", files.nest);
    here_.write("base.dxf", files.base);
    here_.write("skirt.rul", files.rules);
  }
  PatternFile read(const std::string& file) const { return value_or_throw(read_pattern_file(here_ / file)); }

  test::Workplace here_;
};

TEST_F(GradedFilesTest, NestAndRulesComeBackInEverySize) {
  const PatternFile nest = read("nest.dxf"), ruled = read("base.dxf");
  EXPECT_EQ(nest.graded_by, "nest");
  EXPECT_EQ(ruled.graded_by, "rules");
  for (const PatternFile* file : {&nest, &ruled}) {
    EXPECT_EQ(file->sample_size, "38");
    ASSERT_EQ(file->graded.size(), 3u);
    EXPECT_NO_THROW(check_graded(graded(), *file, "f"));
  }
}

TEST_F(GradedFilesTest, AChangeOfATenthOfAMillimetreInOneSizeIsRefused) {
  const PatternFile nest = read("nest.dxf");
  const auto code = [](const PatternFile& file) {
    try {
      check_graded(graded(), file, "nest.dxf");
    } catch (const BadInput& bad) {
      EXPECT_EQ(bad.finding().place, "nest.dxf");
      return bad.finding().code;
    }
    return std::string();
  };
  EXPECT_EQ(code(nest), "");
  for (std::size_t s = 0; s < 3; ++s) {
    PatternFile moved = nest;
    for (Piece& piece : moved.graded[s].pieces)
      if (piece.name == "Aermel") piece.outline[0].points[3].at.y() += .1e-3;
    EXPECT_EQ(code(moved), "export.changed") << s;
    PatternFile bare = nest;
    for (Piece& piece : bare.graded[s].pieces) piece.notches.clear();
    EXPECT_EQ(code(bare), "export.changed") << s;
  }
  PatternFile short_of_one = nest;
  short_of_one.sizes.pop_back();
  short_of_one.graded.pop_back();
  EXPECT_EQ(code(short_of_one), "export.changed");
}

TEST(GradedFiles, TheSizesMustHaveThePattern) {
  PatternFile file = graded();
  file.pattern.sample_size = "50";
  EXPECT_THROW(graded_files(file, "x", {}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
