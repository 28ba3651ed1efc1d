#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <sstream>

#include "formats/formats.h"
#include "formats/svg_drawn.h"

namespace toile {
namespace {

using test::Extent;
using test::extent_mm;

std::filesystem::path corpus() {
  const char* folder = std::getenv("TOILE_CORPUS");
  return folder ? std::filesystem::path(folder) / "patterns" : std::filesystem::path();
}

struct ExpectedPiece {
  const char* name;
  double width, height;  // mm, unfolded net line
  int notches, edges;
  int copies, mirrored;
  bool unfolded;
};
struct Expected {
  const char* file;
  const char* dialect;
  std::vector<ExpectedPiece> pieces;
};

// Width and height from the numbers in the files, doubled where they are halves.
const Expected table[] = {
    {"freesewing/aaron_cisFemaleAdult38_sa10.svg",
     "FreeSewing",
     {{"front", 529.28, 607.67, 0, 8, 1, 0, true},
      {"back", 529.28, 607.67, 0, 8, 1, 0, true},
      {"armBinding", 60, 603.23, 0, 4, 1, 1, false},
      {"neckBinding", 60, 549.55, 0, 4, 1, 0, false}}},
    {"freesewing/bella_cisFemaleAdult38_sa0.svg",
     "FreeSewing",
     {{"back", 249.12, 425, 2, 9, 1, 1, false},
      {"frontSideDart", 646.24, 463.53, 2, 20, 1, 0, true},
      {"sleeve", 347.3, 610.99, 2, 4, 1, 1, false}}},
    {"freesewing/bella_cisFemaleAdult38_sa10.svg",
     "FreeSewing",
     {{"back", 249.12, 425, 2, 9, 1, 1, false},
      {"frontSideDart", 646.24, 463.53, 2, 20, 1, 0, true},
      {"sleeve", 347.3, 610.99, 2, 4, 1, 1, false}}},
    {"freesewing/penelope_cisFemaleAdult32_sa10.svg",
     "FreeSewing",
     {{"back", 278.78, 602.86, 0, 12, 1, 1, false},
      {"front", 476.88, 602.86, 0, 16, 1, 0, true},
      {"waistband", 57.7, 720.2, 0, 4, 1, 0, true}}},
    {"freesewing/penelope_cisFemaleAdult38_sa0.svg",
     "FreeSewing",
     {{"back", 309.32, 674.97, 0, 12, 1, 1, false},
      {"front", 529.4, 674.97, 0, 16, 1, 0, true},
      {"waistband", 64.6, 833.32, 0, 4, 1, 0, true}}},
    {"freesewing/penelope_cisFemaleAdult38_sa10.svg",
     "FreeSewing",
     {{"back", 309.32, 674.97, 0, 12, 1, 1, false},
      {"front", 529.4, 674.97, 0, 16, 1, 0, true},
      {"waistband", 64.6, 833.32, 0, 4, 1, 0, true}}},
    {"freesewing/teagan_cisMaleAdult42_sa0.svg",
     "FreeSewing",
     {{"front", 618.8, 726.55, 2, 8, 1, 0, true},
      {"back", 618.8, 726.55, 2, 8, 1, 0, true},
      {"sleeve", 453.22, 235.57, 2, 4, 1, 1, false}}},
    {"freesewing/teagan_cisMaleAdult42_sa10.svg",
     "FreeSewing",
     {{"front", 618.8, 726.55, 2, 8, 1, 0, true},
      {"back", 618.8, 726.55, 2, 8, 1, 0, true},
      {"sleeve", 453.22, 235.57, 2, 4, 1, 1, false}}},
    {"freesewing/titan_cisFemaleAdult38_sa10.svg",
     "FreeSewing",
     {{"back", 371.75, 1113.79, 0, 5, 1, 1, false}, {"front", 354.13, 1114.49, 0, 5, 1, 1, false}}},
    {"valentina/basicblock_svg_1.svg",
     "Valentina",
     {{"FrontPanel2", 260.8, 1094.86, 0, 12, 1, 1, false},
      {"FrontPanel1", 280.84, 1119.04, 0, 9, 1, 1, false},
      {"BackPanel2", 280, 1089.44, 0, 9, 1, 1, false},
      {"BackPanel1", 280, 1079.85, 0, 9, 1, 1, false}}},
    {"valentina/trousers_svg_1.svg",
     "Valentina",
     {{"Waist Back", 56.27, 45.8, 0, 5, 1, 1, false}, {"piece 2", 125.21, 471, 0, 8, 1, 0, false}}},
};

TEST(SvgCorpus, GivesTheRightPiecesAtTheRightScale) {
  if (corpus().empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const Expected& expected : table) {
    SCOPED_TRACE(expected.file);
    const Loaded<PatternFile> loaded = read_pattern_file(corpus() / expected.file);
    ASSERT_TRUE(loaded.value);
    const PatternFile& file = *loaded.value;
    EXPECT_EQ(file.dialect, expected.dialect);
    ASSERT_EQ(file.pattern.pieces.size(), expected.pieces.size());
    ASSERT_EQ(file.facts.size(), expected.pieces.size());
    for (std::size_t i = 0; i < expected.pieces.size(); ++i) {
      const ExpectedPiece& want = expected.pieces[i];
      const Piece& piece = file.pattern.pieces[i];
      SCOPED_TRACE(want.name);
      EXPECT_EQ(piece.name, want.name);
      EXPECT_NEAR(extent_mm(piece).width, want.width, .06);
      EXPECT_NEAR(extent_mm(piece).height, want.height, .06);
      EXPECT_EQ(piece.notches.size(), static_cast<std::size_t>(want.notches));
      EXPECT_EQ(piece.outline.size(), static_cast<std::size_t>(want.edges));
      EXPECT_EQ(piece.quantity, want.copies);
      EXPECT_EQ(piece.mirrored_quantity, want.mirrored);
      EXPECT_EQ(file.facts[i].unfolded, want.unfolded);
      EXPECT_EQ(file.facts[i].piece, piece.name);
      EXPECT_GT(signed_area(piece), 0);
    }
  }
}

TEST(SvgCorpus, AShirtOfSeventeenPiecesWithoutTextsIsToldApartByContainment) {
  if (corpus().empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  const PatternFile file = value_or_throw(read_pattern_file(corpus() / "valentina/maleshirt_svg_1.svg"));
  ASSERT_EQ(file.pattern.pieces.size(), 17u);
  int sewn = 0;
  double tallest = 0;
  for (std::size_t i = 0; i < 17; ++i) {
    sewn += file.facts[i].has_sew_line;
    tallest = std::max(tallest, extent_mm(file.pattern.pieces[i]).height);
  }
  EXPECT_EQ(sewn, 14);  // the others are cut net
  EXPECT_NEAR(tallest, 743.89, .06);
}

double edge_mm(const Pattern& pattern, const char* piece, std::size_t from_longest) {
  std::vector<double> lengths;
  for (const Edge& edge : find_piece(pattern, piece)->outline)
    if (edge.points.size() > 2) lengths.push_back(length(edge) * 1e3);
  std::sort(lengths.rbegin(), lengths.rend());
  return lengths.at(from_longest);
}

TEST(SvgCorpus, SideSeamsOfThePencilSkirtMate) {
  if (corpus().empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const char* name :
       {"penelope_cisFemaleAdult38_sa0.svg", "penelope_cisFemaleAdult38_sa10.svg", "penelope_cisFemaleAdult32_sa10.svg"}) {
    const Pattern pattern = value_or_throw(read_pattern_file(corpus() / "freesewing" / name)).pattern;
    const double back = edge_mm(pattern, "back", 0);
    EXPECT_NEAR(edge_mm(pattern, "front", 0), back, 1) << name;
    EXPECT_NEAR(edge_mm(pattern, "front", 1), back, 1) << name;
  }
}

TEST(SvgCorpus, SeamsOfShirtAndTrousersMate) {
  if (corpus().empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  const Pattern shirt = value_or_throw(read_pattern_file(corpus() / "freesewing/teagan_cisMaleAdult42_sa10.svg")).pattern;
  EXPECT_NEAR(edge_mm(shirt, "front", 0), edge_mm(shirt, "back", 0), .1);
  const Pattern trousers = value_or_throw(read_pattern_file(corpus() / "freesewing/titan_cisFemaleAdult38_sa10.svg")).pattern;
  EXPECT_NEAR(edge_mm(trousers, "front", 0), edge_mm(trousers, "back", 0), 1);  // outseam
  EXPECT_NEAR(edge_mm(trousers, "front", 1), edge_mm(trousers, "back", 1), 1);  // inseam
}

TEST(SvgCorpus, AllowancesAreMeasuredAndWhereThereIsNoneItIsZero) {
  if (corpus().empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  const Pattern shirt = value_or_throw(read_pattern_file(corpus() / "freesewing/aaron_cisFemaleAdult38_sa10.svg")).pattern;
  std::multimap<int, std::string> tenths;
  for (const Edge& edge : find_piece(shirt, "front")->outline)
    tenths.emplace(static_cast<int>(std::lround(edge.seam_allowance.value_or(-1) * 1e3)), edge.id);
  EXPECT_EQ(tenths.count(25), 1u);  // hem
  EXPECT_EQ(tenths.count(10), 4u);  // shoulders, sides
  EXPECT_EQ(tenths.count(0), 3u);   // bound: armholes, neck
}

// An independent reader: the boxes svgelements finds for the net lines of FreeSewing's parts, mm.
TEST(SvgCorpus, SvgelementsFindsTheSameBoxes) {
  if (corpus().empty()) GTEST_SKIP() << "TOILE_CORPUS is not set";
  if (std::system("/usr/bin/python3 -c 'import svgelements' 2>/dev/null") != 0)
    GTEST_SKIP() << "python3-svgelements is not installed";
  const std::string script =
      "import sys\nfrom svgelements import *\n"
      "for e in SVG.parse(sys.argv[1], ppi=25.4).elements():\n"
      "  if isinstance(e, Path) and e.values.get('class', '').strip() in ('fabric', 'lining', 'interfacing'):\n"
      "    b = e.bbox(); print(b[2]-b[0], b[3]-b[1])\n";
  for (const auto& entry : std::filesystem::directory_iterator(corpus() / "freesewing")) {
    if (entry.path().extension() != ".svg") continue;
    SCOPED_TRACE(entry.path().filename());
    FILE* pipe = popen(("/usr/bin/python3 -c \"" + script + "\" '" + entry.path().string() + "'").c_str(), "r");
    ASSERT_TRUE(pipe);
    std::string output;
    char buffer[512];
    while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
    ASSERT_EQ(pclose(pipe), 0);
    const PatternFile file = value_or_throw(read_pattern_file(entry.path()));
    std::istringstream boxes(output);
    for (std::size_t i = 0; i < file.pattern.pieces.size(); ++i) {
      double width = 0, height = 0;
      ASSERT_TRUE(boxes >> width >> height) << output;
      const Extent read = extent_mm(file.pattern.pieces[i]);
      const bool half = file.facts[i].unfolded;
      const bool same = std::abs(read.width - width) < .1 && std::abs(read.height - height) < .1;
      const bool twice_wide = std::abs(read.width - 2 * width) < .1 && std::abs(read.height - height) < .1;
      const bool twice_high = std::abs(read.width - width) < .1 && std::abs(read.height - 2 * height) < .1;
      EXPECT_TRUE(half ? twice_wide || twice_high : same) << file.pattern.pieces[i].name << " " << width << " x " << height;
    }
    double more = 0;
    EXPECT_FALSE(boxes >> more);
  }
}

}  // namespace
}  // namespace toile
