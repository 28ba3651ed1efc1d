// A pattern with a piece that lies on others: it is cut, not draped.

#include <gtest/gtest.h>

#include "cli/program.h"
#include "cut/cut.h"
#include "formats/formats.h"
#include "formats/seams/seams.h"

namespace toile::test {
namespace {

Piece pocket() {
  Piece piece;
  piece.name = "POCKET";
  piece.quantity = 2;
  piece.sewn = false;
  const std::vector<Eigen::Vector2d> corners{{0, 0}, {.14, 0}, {.14, .16}, {.07, .18}, {0, .16}};
  for (std::size_t k = 0; k < corners.size(); ++k)
    piece.outline.push_back(
        {"e" + std::to_string(k), {{corners[k], true, {}}, {corners[(k + 1) % corners.size()], true, {}}}, {}, false});
  piece.grainline = Grainline{{.07, .02}, {.07, .15}};
  return piece;
}

TEST(UnsewnPieces, AreOnTheCutSheetAsTheyWere) {
  const Workplace here;
  const std::filesystem::path sample = TOILE_SOURCE_DIR "/samples/gored_skirt/gored_skirt.dxf";
  Pattern pattern = value_or_throw(read_pattern(sample, {std::nullopt, seams_beside(sample)}));
  pattern.pieces.insert(pattern.pieces.begin(), pocket());
  const CutSheet sheet = lay_out(pattern, {});
  write_dxf_aama(here / "skirt.dxf", sheet);
  write_seams(here / "skirt.seams.toml", as_named_in_dxf(pattern, sheet));
  here.write("shorter.toml",
             "[pattern]\nfile = \"skirt.dxf\"\n[body]\nsize = \"38\"\n[fabric]\nname = \"jersey\"\n"
             "[drape]\nedge_length = \"30 mm\"\ntolerance = 1e-3\n[[edit]]\noperation = \"length\"\nby = \"-5 cm\"\n"
             "[adjust]\nsteps = 1\n");
  const Ended ended = run_program({"run", (here / "shorter.toml").string(), "--out", (here / "out").string()});
  EXPECT_TRUE(ended.status == 0 || ended.status == 10) << ended.err;  // so coarse a mesh may miss a bound
  EXPECT_NE(ended.err.find("warning[pieces.not-sewn]"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("'POCKET'"), std::string::npos) << ended.err;

  const auto written = here / "out/shorter.dxf";
  const Pattern shorter = value_or_throw(read_pattern(written, {std::nullopt, seams_beside(written)}));
  ASSERT_EQ(shorter.pieces.size(), pattern.pieces.size());
  const Piece* left = find_piece(shorter, "POCKET");
  ASSERT_TRUE(left);
  EXPECT_FALSE(left->sewn);
  EXPECT_EQ(left->quantity, 2);
  EXPECT_NEAR(signed_area(*left), signed_area(pocket()), 1e-6);
  EXPECT_LT(signed_area(*find_piece(shorter, "GORE")), .95 * signed_area(*find_piece(pattern, "GORE")));
  EXPECT_EQ(contents(here / "out/target.obj").find("POCKET"), std::string::npos);
}

}  // namespace
}  // namespace toile::test
