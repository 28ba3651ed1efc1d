// A pattern written as DXF with its seams file beside it.

#include <gtest/gtest.h>

#include "formats/aama_pieces.h"
#include "formats/folder.h"
#include "formats/formats.h"

namespace toile {
namespace {

Pattern sleeves() {
  Pattern pattern;
  for (const char* name : {"Ärmel", "Aermel", "Rücken: Mitte", "袖", "近"}) {
    Piece piece = band(.3 + .05 * static_cast<double>(pattern.pieces.size()), .2);
    piece.name = name;
    piece.outline[0].id = "Säum";
    pattern.pieces.push_back(piece);
  }
  pattern.seams.push_back({"Ärmelnaht", {"Ärmel", 1, "e1"}, {"Ärmel", 1, "e3", 1, 0}});
  pattern.seams.push_back({"zu", {"Aermel", 1, "e1"}, {"Rücken: Mitte", 1, "e3", 1, 0}});
  pattern.seams.push_back({"袖下", {"袖", 1, "e1"}, {"近", 1, "Säum", 0, .5}});
  return pattern;
}

TEST(DxfWithSeams, ReadsBackWhateverThePiecesAreCalled) {
  const test::Folder folder;
  const Pattern pattern = sleeves();
  const CutSheet sheet = sheet_of(pattern.pieces);
  const Pattern written = as_named_in_dxf(pattern, sheet);
  write_dxf_aama(folder / "dress.dxf", sheet);
  write_seams(folder / "dress.seams.toml", written);

  const Loaded<Pattern> read = read_pattern(folder / "dress.dxf");
  for (const Finding& finding : read.report.findings) EXPECT_NE(finding.severity, Severity::error) << in_words(finding);
  ASSERT_TRUE(read.value);
  ASSERT_EQ(read.value->pieces.size(), pattern.pieces.size());
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    const Piece* found = find_piece(*read.value, written.pieces[p].name);
    ASSERT_TRUE(found) << written.pieces[p].name;
    ASSERT_TRUE(find_edge(*found, "Säum"));
    EXPECT_NEAR(length(*find_edge(*found, "Säum")), length(pattern.pieces[p].outline[0]), 1e-6);
  }
  ASSERT_EQ(read.value->seams.size(), pattern.seams.size());
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    EXPECT_EQ(read.value->seams[s].name, pattern.seams[s].name);
    EXPECT_EQ(read.value->seams[s].a.piece, written.seams[s].a.piece);
    EXPECT_EQ(read.value->seams[s].b.piece, written.seams[s].b.piece);
  }
}

TEST(DxfWithSeams, NamesAreLetterForLetterWhereTheyCanBe) {
  const Pattern pattern = sleeves();
  const Pattern written = as_named_in_dxf(pattern, sheet_of(pattern.pieces));
  EXPECT_EQ(written.pieces[0].name, "Aermel");
  EXPECT_EQ(written.pieces[1].name, "Aermel-2");
  EXPECT_EQ(written.pieces[2].name, "Ruecken: Mitte");
  EXPECT_EQ(written.seams[1].b.piece, "Ruecken: Mitte");
  EXPECT_NE(written.pieces[3].name, written.pieces[4].name);
  const Pattern plain{.pieces = {band()}};
  EXPECT_EQ(as_named_in_dxf(plain, sheet_of(plain.pieces)), plain);
}

}  // namespace
}  // namespace toile
