#include <gtest/gtest.h>

#include <cmath>

#include "cut/cut.h"
#include "formats/formats.h"
#include "formats/pdf/papers.h"
#include "formats/pdf/tiling.h"
#include "formats/pdf/write_pdf.h"
#include "formats/pdf_judges.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using test::Folder;
using test::page_sizes;
using test::Picture;

constexpr double point = 25.4 / 72;  // mm

// A rectangle with its lower left corner at (x, y) of the page, m. No allowance.
PlacedPiece rectangle(const std::string& name, double x, double y, double width, double height) {
  Piece piece;
  piece.name = name;
  const Vector2d corners[] = {{0, 0}, {width, 0}, {width, height}, {0, height}};
  const char* ids[] = {"bottom", "right", "top", "left"};
  for (std::size_t i = 0; i < 4; ++i) {
    Edge edge;
    edge.id = ids[i];
    edge.points = {{corners[i], true, {}}, {corners[(i + 1) % 4], true, {}}};
    piece.outline.push_back(edge);
  }
  AllowanceRules none;
  none.allowance = none.hem = 0;
  PlacedPiece placed;
  placed.cut = add_allowance(piece, none);
  placed.cut.labels = {name};
  placed.shift = {x, y};
  return placed;
}

CutSheet sheet_of(double width, double length, std::vector<PlacedPiece> placed) {
  CutSheet sheet;
  sheet.title = "Rock <6> Größe 38";
  sheet.page_width = width;
  sheet.page_length = length;
  sheet.placed = std::move(placed);
  sheet.notes = {"Re-drape of this pattern: mean 0.80 mm"};
  return sheet;
}

CutSheet one_piece() { return sheet_of(.4, .5, {rectangle("FRONT", .05, .05, .3, .4)}); }

std::filesystem::path written(const Folder& folder, const CutSheet& sheet, const PrintOptions& options,
                              const SheetStyle& style = {}) {
  const std::filesystem::path file = folder / (options.paper + ".pdf");
  write_pdf(file, sheet, style, options);
  return file;
}

std::string code_of(const CutSheet& sheet, const PrintOptions& options) {
  try {
    pdf_bytes(sheet, {}, options);
  } catch (const BadInput& bad) {
    return bad.finding().code;
  }
  return "";
}

// By independent programs.
class PdfSeen : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* judge : {"pdfinfo", "qpdf"})
      if (std::system(("command -v " + std::string(judge) + " >/dev/null").c_str()) != 0)
        GTEST_SKIP() << judge << " is not installed";
  }
};

TEST(Tiling, TakesTheFewestPagesThatCoverTheSheet) {
  const Tiling tiling = tiled({1500, 800}, {210, 297}, 10, 10);  // windows of 190 x 277, every 180 x 267
  EXPECT_EQ(tiling.columns, 9);
  EXPECT_EQ(tiling.rows, 3);
  EXPECT_EQ(tiled({190, 277}, {210, 297}, 10, 10).columns, 1);
  EXPECT_EQ(tiled({370, 277}, {210, 297}, 10, 10).columns, 2);
  EXPECT_EQ(tiled({370.01, 277}, {210, 297}, 10, 10).columns, 3);
  for (const double overlap : {0., 10., 33.})
    for (double length = 20; length < 3000; length += 37) {
      const Tiling each = tiled({length, length / 2}, {210, 297}, 12, overlap);
      for (const int axis : {0, 1}) {
        const int pages = axis == 0 ? each.columns : each.rows;
        const double sheet = axis == 0 ? length : length / 2;
        const auto end = [&](int page) { return each.corner(page, page)[axis] + each.window()[axis]; };
        EXPECT_GE(end(pages - 1), sheet - 1e-6);
        if (pages > 1) {
          EXPECT_LT(end(pages - 2), sheet);
          EXPECT_NEAR(end(0) - each.corner(1, 1)[axis], overlap, 1e-9);
        }
      }
    }
  EXPECT_THROW(tiled({100, 100}, {50, 50}, 20, 10), std::invalid_argument);
}

TEST(Tiling, EndsWithTheLastColumnThatIsPrinted) {
  TilePlan plan{tiled({700, 500}, {210, 297}, 10, 10), {false, true, false, false, true, false, false, false}};
  ASSERT_EQ(plan.tiling.columns, 4);
  plan.drop_empty_columns();
  EXPECT_EQ(plan.tiling.columns, 2);
  EXPECT_EQ(plan.printed, (std::vector<bool>{false, true, true, false}));
  EXPECT_EQ(plan.pages(), 2);
  EXPECT_TRUE(plan.prints(1, 0));
  EXPECT_FALSE(plan.prints(1, 2));
}

TEST(Tiling, NamesRowsByLettersAndColumnsByNumbers) {
  EXPECT_EQ(tile_name(0, 0), "A1");
  EXPECT_EQ(tile_name(2, 11), "C12");
  EXPECT_EQ(tile_name(25, 0), "Z1");
  EXPECT_EQ(tile_name(26, 0), "AA1");
  EXPECT_EQ(tile_name(52, 3), "BA4");
}

TEST(Tiling, SplitsARollOnlyWhereAPdfEnds) {
  EXPECT_EQ(unrolled({1500, 5080}, 10, 10), (Tiling{{1500, 5080}, {0, 0}, 10, 1, 1}));
  const Tiling split = unrolled({1500, 5081}, 10, 10);
  EXPECT_EQ(split.rows, 2);
  EXPECT_EQ(split.columns, 1);
  EXPECT_DOUBLE_EQ(split.page.x(), 1500);
  EXPECT_DOUBLE_EQ(split.page.y(), (5081 + 10) / 2. + 20);
  EXPECT_DOUBLE_EQ((split.corner(1, 0) + split.window()).y(), 5081);
  EXPECT_EQ(unrolled({1500, 20000}, 10, 10).rows, 4);
}

TEST(Papers, AreFoundByName) {
  EXPECT_DOUBLE_EQ(find_paper("A4")->length, .297);
  EXPECT_DOUBLE_EQ(find_paper("letter")->width, .2159);
  EXPECT_EQ(find_paper("a9"), nullptr);
  EXPECT_EQ(find_paper("roll"), nullptr);
  EXPECT_TRUE(is_roll("None"));
}

TEST_F(PdfSeen, OfARollIsOnePageOfTheSheetsSize) {
  const Folder folder;
  const auto file = written(folder, sheet_of(1.5, .8, {rectangle("FRONT", .1, .1, .3, .4)}), {});
  const auto sizes = page_sizes(file);
  ASSERT_EQ(sizes.size(), 1u);
  EXPECT_NEAR(sizes[0].first * point, 1500, .01);
  EXPECT_GT(sizes[0].second * point, 850);  // and the heading
  const std::string text = test::text_of(file);
  for (const char* words : {"FRONT", "Rock <6> Größe 38", "Re-drape of this pattern: mean 0.80 mm", "50 mm", "2 in"})
    EXPECT_NE(text.find(words), std::string::npos) << words << " in " << text;
}

TEST_F(PdfSeen, IsTrueToSizeOnTheRoll) {
  const Folder folder;
  const auto file = written(folder, one_piece(), {});
  const Picture page = test::picture_of(file, 1);
  const double y = page.height / 10. - 150;  // through the piece, below its label
  const double left = page.to_line(1, y, 1, 0);
  EXPECT_NEAR(1 + left, 50, .15);
  EXPECT_NEAR(2 + left + page.to_line(2 + left, y, 1, 0), 350, .15);
  EXPECT_NEAR(page.to_line(100, page.height / 10. - 1, 0, -1), 49, .15);
}

TEST_F(PdfSeen, SplitsARollThatIsTooLong) {
  const Folder folder;
  const CutSheet sheet = sheet_of(.3, 7, {rectangle("BELT", .05, .05, .2, 6.9)});
  const auto roll = page_sizes(written(folder, sheet, {}));
  ASSERT_EQ(roll.size(), 2u);
  for (const auto& [width, height] : roll) {
    EXPECT_NEAR(width * point, 300, .01);
    EXPECT_LE(height, 14400);
    EXPECT_NEAR(height, roll[0].second, .01);
  }
  EXPECT_NEAR(2 * roll[0].second * point, 7000 + 2 * 20 + 10, 400);  // heading too
  EXPECT_GT(2 * roll[0].second * point, 7000 + 2 * 20 + 10);
}

TEST_F(PdfSeen, TilesAreUniformPagesThatCoverTheSheet) {
  const Folder folder;
  for (const auto& [name, width, length] : {std::tuple{"a4", 210., 297.}, std::tuple{"letter", 215.9, 279.4}}) {
    // The rectangle fills the sheet: no page is empty.
    const CutSheet sheet = sheet_of(.9, .7, {rectangle("FRONT", 0, 0, .9, .7)});
    const auto file = written(folder, sheet, {name, .010, .015});
    const Tiling tiling = tiled({900, 700}, {width, length}, 10, 15);
    const auto sizes = page_sizes(file);
    EXPECT_EQ(static_cast<int>(sizes.size()), 1 + tiling.rows * tiling.columns);
    for (const auto& [w, h] : sizes) {
      EXPECT_NEAR(w * point, width, .01);
      EXPECT_NEAR(h * point, length, .01);
    }
  }
}

TEST_F(PdfSeen, EveryTileShowsItsPartAtTrueSize) {
  const Folder folder;
  const auto file = written(folder, one_piece(), {"a4", .010, .010});
  ASSERT_EQ(page_sizes(file).size(), 1u + 2 * 2);  // windows of 190 x 277 every 180 x 267; nothing is right of 350 mm
  // Left, right, lower and upper line of the piece are 50, 350, 450 and 50 mm from the sheet's upper left corner.
  const Picture a1 = test::picture_of(file, 2), a2 = test::picture_of(file, 3), b1 = test::picture_of(file, 4);
  EXPECT_NEAR(15 + a1.to_line(15, 100, 1, 0), 10 + 50, .15);
  EXPECT_NEAR(20 + a1.to_line(150, 20, 0, 1), 10 + 50, .15);
  EXPECT_NEAR(15 + a2.to_line(15, 100, 1, 0), 10 + 350 - 180, .15);
  EXPECT_NEAR(20 + b1.to_line(150, 20, 0, 1), 10 + 450 - 267, .15);
}

TEST_F(PdfSeen, WhatIsOnTheRollIsOnEveryTileThatReachesThere) {
  const Folder folder;
  CutSheet sheet = sheet_of(.5, .6, {rectangle("FRONT", .01, .01, .3, .4), rectangle("BAND", .44, .02, .03, .5)});
  sheet.placed[1].turn = .1;
  const Picture roll = test::picture_of(written(folder, sheet, {}), 1);
  const auto tiles = written(folder, sheet, {"a4", .010, .010});
  const Tiling tiling = tiled({500, 600}, {210, 297}, 10, 10);
  ASSERT_EQ(page_sizes(tiles).size(), 1u + 3 * 3);
  const double heading = roll.height / 10. - 600;
  int seen = 0, missing = 0;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      const Picture tile = test::picture_of(tiles, 2 + 3 * row + column);
      const auto dark_near = [&](double x, double y) {
        for (const double dx : {0., -.1, .1})
          for (const double dy : {0., -.1, .1})
            if (tile.at(x + dx, y + dy) < 140) return true;
        return false;
      };
      const Vector2d corner = tiling.corner(row, column);
      for (double y = .5; y < 276.5 && corner.y() + y < 600; y += .1)
        for (double x = .5; x < 189.5 && corner.x() + x < 500; x += .1) {
          if (roll.at(corner.x() + x, heading + corner.y() + y) >= 85) continue;
          ++seen;
          if (!dark_near(10 + x, 10 + y)) ++missing;
        }
    }
  EXPECT_GT(seen, 100'000);
  EXPECT_EQ(missing, 0);
}

TEST_F(PdfSeen, TheTestSquareIsFiftyMillimetres) {
  const Folder folder;
  for (const char* paper : {"a4", "letter", "roll"}) {
    const auto file = written(folder, one_piece(), {paper, .010, .010});
    const Picture cover = test::picture_of(file, 1);
    for (const auto& [word, side] : {std::pair{"cm", 50.}, std::pair{"inch", 50.8}}) {
      const auto [x, y] = test::place_of_word(file, 1, word);  // the lower line of words in the square
      const double clear = 12;                                 // mm, from there: below them all
      const double across = cover.to_line(x, y + clear, -1, 0) + cover.to_line(x, y + clear, 1, 0);
      const double along = clear + cover.to_line(x, y + clear, 0, 1) + cover.to_line(x + 20, y, 0, -1);
      EXPECT_NEAR(across, side, .15) << paper;
      EXPECT_NEAR(along, side, .15) << paper;
    }
  }
}

TEST_F(PdfSeen, LeavesOutPagesWithNothingOnThem) {
  const Folder folder;
  // Two small pieces in opposite corners of 9 x 6 pages.
  const CutSheet far = sheet_of(1.5, 1.5, {rectangle("LOW", 0, 0, .1, .1), rectangle("HIGH", 1.46, 1.46, .04, .04)});
  const auto file = written(folder, far, {"a4", .010, .010});
  EXPECT_EQ(page_sizes(file).size(), 1u + 2u);
  const std::string text = test::text_of(file, 1, 1);
  EXPECT_NE(text.find("2 pages"), std::string::npos) << text;
  EXPECT_NE(text.find("52 with nothing on them left out"), std::string::npos) << text;
  EXPECT_NE(test::text_of(file, 2, 2).find("A9"), std::string::npos);
  EXPECT_NE(test::text_of(file, 2, 2).find("A8 is empty: not printed"), std::string::npos);
  EXPECT_NE(test::text_of(file, 3, 3).find("F1"), std::string::npos);
  // A page inside a piece is printed though no line is on it: the paper pattern has no holes.
  EXPECT_EQ(page_sizes(written(folder, sheet_of(.9, .9, {rectangle("BIG", 0, 0, .9, .9)}), {"letter", .010, .010})).size(),
            1u + 5 * 4);
}

TEST_F(PdfSeen, NeighboursNameEachOther) {
  const Folder folder;
  const auto file = written(folder, one_piece(), {"a4", .010, .010});
  const std::string a1 = test::text_of(file, 2, 2), b2 = test::text_of(file, 5, 5);
  EXPECT_NE(a1.find("B1 comes here, up to the dashed line"), std::string::npos) << a1;
  EXPECT_EQ(a1.find("cut here"), std::string::npos) << a1;
  EXPECT_NE(b2.find("cut here, lay on A2"), std::string::npos) << b2;
  EXPECT_NE(b2.find("page 5 of 5"), std::string::npos) << b2;
}

TEST_F(PdfSeen, PrintsTheCertificateAndTheNamesOfThePieces) {
  const Folder folder;
  const auto file = written(folder, one_piece(), {"a4", .010, .010});
  const std::string cover = test::text_of(file, 1, 1);
  for (const char* words : {"Re-drape of this pattern: mean 0.80 mm", "actual size (100 %", "A1", "B2"})
    EXPECT_NE(cover.find(words), std::string::npos) << words << " in " << cover;
  EXPECT_NE(test::text_of(file, 2).find("FRONT"), std::string::npos);
}

TEST_F(PdfSeen, ManyNotesTakeAPageOfTheirOwn) {
  const Folder folder;
  CutSheet sheet = one_piece();
  for (int i = 0; i < 200; ++i) sheet.notes.push_back("note " + std::to_string(i));
  const auto file = written(folder, sheet, {"a4", .010, .010});
  EXPECT_EQ(page_sizes(file).size(), 2u + 2 * 2);
  const std::string notes = test::text_of(file, 1, 1), map = test::text_of(file, 2, 2);
  EXPECT_NE(notes.find("note 19\n"), std::string::npos);
  EXPECT_NE(notes.find("notes that have no room on this paper"), std::string::npos);
  EXPECT_NE(notes.find("drill hole"), std::string::npos);  // squares and legend stand below
  EXPECT_NE(map.find("B2"), std::string::npos) << map;
  EXPECT_GT(test::place_of_word(file, 2, "B2").first, test::place_of_word(file, 2, "B1").first);
}

TEST_F(PdfSeen, AsksForActualSizeAndHoldsNoPictures) {
  const Folder folder;
  for (const char* paper : {"a4", "roll"}) {
    const auto file = written(folder, one_piece(), {paper, .010, .010});
    const std::string objects = test::inside(file);
    EXPECT_NE(objects.find("/PrintScaling /None"), std::string::npos);
    EXPECT_EQ(objects.find("/CreationDate"), std::string::npos);
    EXPECT_EQ(objects.find("/Subtype /Image"), std::string::npos);
    EXPECT_EQ(objects.find("/Subtype /Type3"), std::string::npos);  // letters drawn
    test::said_by("qpdf --check " + test::quoted(file));
    EXPECT_LT(std::filesystem::file_size(file), 40'000u);
  }
}

TEST_F(PdfSeen, KeepsWidthsAndDashes) {
  const Folder folder;
  SheetStyle style;
  style.sew.width = 1e-3;
  style.sew.dash = {7e-3, 4e-3};
  const auto file = written(folder, one_piece(), {}, style);
  const Picture page = test::picture_of(file, 1);
  // Down the middle of the left line: dashes of 7 mm and gaps of 4 mm of the sew line over the cut line of .5 mm; beside it,
  // where only the wider sew line is, gaps are white.
  const double top = page.height / 10. - 440;
  std::vector<int> runs{0};
  bool dark = page.at(49.6, top) < 160;
  for (double y = top; y < top + 300; y += .1) {
    const bool now = page.at(49.6, y) < 160;
    if (now != dark) runs.push_back(0);
    dark = now;
    ++runs.back();
  }
  ASSERT_GT(runs.size(), 40u);
  for (std::size_t i = 1; i + 1 < runs.size(); ++i)
    EXPECT_TRUE(std::abs(runs[i] - 70) <= 2 || std::abs(runs[i] - 40) <= 2) << runs[i];
}

TEST(Pdf, TheSameSheetIsTheSameBytes) {
  for (const char* paper : {"a3", "roll"}) EXPECT_EQ(pdf_bytes(one_piece(), {}, {paper}), pdf_bytes(one_piece(), {}, {paper}));
}

TEST(Pdf, RefusesWhatCannotBePrinted) {
  EXPECT_EQ(code_of(one_piece(), {"a9"}), "pdf.no-such-paper");
  EXPECT_EQ(code_of(one_piece(), {"a4", .004}), "pdf.margin");
  EXPECT_EQ(code_of(one_piece(), {"a4", .08}), "pdf.margin");
  EXPECT_EQ(code_of(one_piece(), {"a4", NAN}), "pdf.margin");
  EXPECT_EQ(code_of(one_piece(), {"a4", .01, .06}), "pdf.overlap");
  EXPECT_EQ(code_of(one_piece(), {"a4", .01, -.01}), "pdf.overlap");
  EXPECT_EQ(code_of(sheet_of(100, 100, {rectangle("SAIL", 0, 0, 99, 99)}), {"a4"}), "pdf.too-many-pages");
  EXPECT_EQ(code_of(CutSheet{}, {"a4"}), "svg.empty-sheet");
  EXPECT_EQ(code_of(CutSheet{}, {}), "svg.empty-sheet");
  EXPECT_EQ(code_of(one_piece(), {"letter", .005, 0}), "");
  const Folder folder;
  EXPECT_THROW(write_pdf(folder / "none" / "a.pdf", one_piece(), {}, {}), BadInput);
  EXPECT_EQ(folder.entries(), 0u);
}

TEST(Pdf, IsNotRead) {
  const Folder folder;
  for (const auto& file :
       {folder.write("a.pdf", "%PDF-1.6\n"), folder.write("b.dxf", "%PDF-1.6\n"), folder.write("c.pdf", "")}) {
    const auto read = read_pattern_file(file);
    ASSERT_FALSE(read.value);
    EXPECT_EQ(read.report.findings.front().code, "format.pdf") << file;
    EXPECT_NE(read.report.findings.front().remedy.find("DXF"), std::string::npos);
  }
}

}  // namespace
}  // namespace toile
