#include <gtest/gtest.h>

#include "formats/folder.h"
#include "formats/formats.h"
#include "formats/svg_drawn.h"
#include "formats/svg_read/words.h"

namespace toile {
namespace {

using test::extent_mm;
using test::has_finding;
using test::read_text;
using test::svg_mm;

PatternFile value_of(const std::string& text) { return value_or_throw(read_text(text)); }
const std::string skirt = "M100,100 L300,100 L320,700 L80,700 Z";  // mm, 240 x 600

TEST(SvgRead, APlainOutlineIsAPieceOfItsSize) {
  const Loaded<PatternFile> loaded = read_text(svg_mm("<path d='" + skirt + "'/>"));
  ASSERT_TRUE(loaded.value);
  const PatternFile& file = *loaded.value;
  ASSERT_EQ(file.pattern.pieces.size(), 1u);
  const Piece& piece = file.pattern.pieces[0];
  EXPECT_NEAR(extent_mm(piece).width, 240, 1e-9);
  EXPECT_NEAR(extent_mm(piece).height, 600, 1e-9);
  EXPECT_EQ(piece.outline.size(), 4u);
  EXPECT_GT(signed_area(piece), 0);
  EXPECT_EQ(file.units.name, "mm");
  EXPECT_EQ(file.format, "SVG");
  EXPECT_TRUE(has_finding(loaded.report, "svg.no-sew-line"));  // net or cut: the file does not say
  EXPECT_FALSE(file.facts[0].has_sew_line);
  // y up: the narrow side is above.
  double above = 0;
  for (const Edge& edge : piece.outline)
    if (std::abs(length(edge) - .2) < 1e-9) above = edge.points[0].at.y() - piece.outline[0].points[0].at.y();
  EXPECT_GE(above, 0);
}

TEST(SvgRead, EveryShapeAndWayToDrawTheSameRectangleReadsTheSame) {
  const char* ways[] = {
      "<rect x='50' y='60' width='200' height='300'/>",
      "<polygon points='50,60 250,60 250,360 50,360'/>",
      "<polyline fill='none' stroke='black' points='50 60 250 60 250 360 50 360 50 60'/>",
      "<g transform='translate(50 60) scale(2)'><path d='m0,0h100v150h-100z'/></g>",
      "<defs><rect id='r' width='200' height='300'/></defs><use xlink:href='#r' x='50' y='60'/>",
      "<symbol id='s' viewBox='0 0 20 30'><rect width='20' height='30'/></symbol><use href='#s' x='50' y='60' width='200' "
      "height='300'/>",
      "<svg x='50' y='60' width='200' height='300' viewBox='0 0 2 3'><rect width='2' height='3'/></svg>",
      "<line x1='50' y1='60' x2='250' y2='60' stroke='red'/><line x1='250' y1='60' x2='250' y2='360' stroke='red'/>"
      "<line x1='50' y1='360' x2='250' y2='360' stroke='red'/><line x1='50' y1='360' x2='50' y2='60' stroke='red'/>",
      "<switch><foreignObject width='1' height='1'/><g><rect x='50' y='60' width='200' height='300'/></g></switch>",
      "<rect x='50' y='60' width='200' height='300'/><rect display='none' x='5' y='6' width='20' height='300'/>"
      "<g style='display:none'><rect x='400' y='6' width='200' height='300'/></g><rect visibility='hidden' x='600' width='200' "
      "height='300'/>",
  };
  for (const char* way : ways) {
    const PatternFile file = value_of(svg_mm(way));
    ASSERT_EQ(file.pattern.pieces.size(), 1u) << way;
    const Piece& piece = file.pattern.pieces[0];
    EXPECT_EQ(piece.outline.size(), 4u) << way;
    EXPECT_NEAR(signed_area(piece), .06, 1e-9) << way;
    for (const Edge& edge : piece.outline) {
      EXPECT_EQ(edge.points.size(), 2u) << way;
      for (const OutlinePoint& p : edge.points) {
        EXPECT_NEAR(std::min(std::abs(p.at.x() - .05), std::abs(p.at.x() - .25)), 0, 1e-9) << way;
        EXPECT_NEAR(std::min(std::abs(p.at.y() + .06), std::abs(p.at.y() + .36)), 0, 1e-9) << way;
      }
    }
  }
}

TEST(SvgRead, UnitsComeFromWidthViewBoxAndProgram) {
  const auto width_of = [](const std::string& root, const std::string& before = "") {
    const PatternFile file = value_of(before + "<svg xmlns='http://www.w3.org/2000/svg' " + root +
                                      "><rect x='0' y='0' width='960' height='1200' fill='none' stroke='black'/></svg>");
    return extent_mm(file.pattern.pieces.at(0)).width;
  };
  EXPECT_NEAR(width_of("width='1000mm' height='2000mm' viewBox='0 0 1000 2000'"), 960, 1e-6);
  EXPECT_NEAR(width_of("width='100cm' height='200cm' viewBox='-55.57 -142.56 1000 2000'"), 960, 1e-6);
  EXPECT_NEAR(width_of("width='10in' height='20in' viewBox='0 0 1000 2000'"), 243.84, 1e-6);
  EXPECT_NEAR(width_of("width='1000' height='2000' viewBox='0 0 1000 2000'"), 254, 1e-6);
  EXPECT_NEAR(width_of("width='1000px' height='2000px'"), 254, 1e-6);
  EXPECT_NEAR(width_of("width='1000px' height='2000px'", "<!-- Generator: Adobe Illustrator 24.0, SVG Export -->"),
              960 * 25.4 / 72, 1e-6);
  EXPECT_NEAR(width_of("width='1000' height='2000' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
                       "inkscape:version='0.48.4 r9939'"),
              960 * 25.4 / 90, 1e-6);
  EXPECT_NEAR(width_of("width='1000' height='2000' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
                       "inkscape:version='1.2.2 (b0a84865)'"),
              254, 1e-6);
}

TEST(SvgRead, AnUnknownScaleIsAQuestionAndAnAnswerIsTaken) {
  const std::string text =
      "<svg xmlns='http://www.w3.org/2000/svg' width='100%' height='100%' viewBox='0 0 1000 2000'><rect width='600' "
      "height='900'/></svg>";
  const Loaded<PatternFile> loaded = read_text(text);
  ASSERT_FALSE(loaded.value);
  const Finding& finding = loaded.report.findings.back();
  EXPECT_EQ(finding.code, "svg.units-ambiguous");
  EXPECT_EQ(finding.fault, Fault::ambiguous);
  const Loaded<PatternFile> answered = read_svg_bytes(text, "drawn.svg", 1e-3);
  ASSERT_TRUE(answered.value);
  EXPECT_NEAR(extent_mm(answered.value->pattern.pieces[0]).width, 600, 1e-9);
  EXPECT_EQ(answered.value->units.decided_by, "override");
}

TEST(SvgRead, ATestSquareCorrectsTheScale) {
  // Drawn for 90 pixels an inch in a file that says 96.
  const std::string square =
      "<rect x='20' y='20' width='177.165' height='177.165' fill='none' stroke='black'/><text x='40' y='100'>5 cm x 5 "
      "cm</text>";
  const Loaded<PatternFile> loaded = read_text("<svg xmlns='http://www.w3.org/2000/svg' width='2000' height='2000'>" + square +
                                               "<path d='M300,300 h900 v900 h-900 z'/></svg>");
  ASSERT_TRUE(loaded.value);
  ASSERT_EQ(loaded.value->pattern.pieces.size(), 1u);
  EXPECT_NEAR(extent_mm(loaded.value->pattern.pieces[0]).width, 254, .01);
  EXPECT_EQ(loaded.value->units.decided_by, "test square");
  EXPECT_TRUE(has_finding(loaded.report, "svg.test-square"));
}

TEST(SvgRead, TheInnerParallelLineIsTheSewLine) {
  const PatternFile file =
      value_of(svg_mm("<path d='M100,100 h200 v400 h-200 z'/><path stroke='black' fill='none' stroke-dasharray='3' d='M110,115 "
                      "h180 v375 h-180 z'/>"));
  ASSERT_EQ(file.pattern.pieces.size(), 1u);
  EXPECT_NEAR(extent_mm(file.pattern.pieces[0]).width, 180, 1e-9);
  EXPECT_TRUE(file.facts[0].has_sew_line);
  std::vector<double> widths;
  for (const Edge& edge : file.pattern.pieces[0].outline) widths.push_back(edge.seam_allowance.value_or(-1) * 1e3);
  std::sort(widths.begin(), widths.end());
  EXPECT_NEAR(widths[0], 10, .02);
  EXPECT_NEAR(widths[3], 15, .02);
}

TEST(SvgRead, LayersNameTheLinesInSeveralLanguages) {
  for (const auto& [cut, sew] :
       {std::pair{"CUT", "Stitch line"}, {"Schnittlinie", "Nahtlinie"}, {"Ligne de coupe", "couture"}, {"corte", "Costura"}}) {
    const std::string layer = "<g inkscape:groupmode='layer' inkscape:label='";
    const PatternFile file = value_of(svg_mm(layer + cut + "'><path d='M100,100 h200 v400 h-200 z'/></g>" + layer + sew +
                                             "'><path d='M120,160 h160 v280 h-160 z'/></g>"));
    ASSERT_EQ(file.pattern.pieces.size(), 1u) << cut;
    EXPECT_NEAR(extent_mm(file.pattern.pieces[0]).width, 160, 1e-9) << cut;
    EXPECT_EQ(file.facts[0].sew_line_source, "name of its class or layer") << cut;
  }
}

TEST(SvgRead, AStatedAllowanceIsTakenOffTheCutLine) {
  const Loaded<PatternFile> loaded =
      read_text(svg_mm("<path d='M100,100 h200 v400 h-200 z'/><text x='150' y='200'>Front</text><text x='150' y='220'>inkl. 1 "
                       "cm Nahtzugabe</text>"));
  ASSERT_TRUE(loaded.value);
  const Piece& piece = loaded.value->pattern.pieces.at(0);
  EXPECT_NEAR(extent_mm(piece).width, 180, 1e-6);
  EXPECT_NEAR(extent_mm(piece).height, 380, 1e-6);
  EXPECT_EQ(loaded.value->facts[0].sew_line_source, "cut line less 10.0 mm");
  for (const Edge& edge : piece.outline) EXPECT_NEAR(edge.seam_allowance.value_or(0), .01, 2e-5);
}

TEST(SvgRead, TextsGiveNameQuantityAndFold) {
  const Loaded<PatternFile> loaded = read_text(
      svg_mm("<path d='M100,100 h200 v400 h-200 z'/><g font-size='8'><text x='150' y='200' font-size='20'>Rockteil vorne</text>"
             "<text x='150' y='260'>2x im Stoffbruch zuschneiden</text><text x='90' y='300'>Stoffbruch</text></g>"
             "<path stroke='black' d='M250,150 V400'/><path stroke='black' fill='none' d='M245,158 L250,150 L255,158'/><path "
             "stroke='black' fill='none' d='M245,392 L250,400 L255,392'/>"
             "<circle cx='200' cy='300' r='2'/>"));
  ASSERT_TRUE(loaded.value);
  const Piece& piece = loaded.value->pattern.pieces.at(0);
  EXPECT_EQ(piece.name, "Rockteil vorne");
  EXPECT_EQ(piece.quantity, 2);
  EXPECT_EQ(piece.mirrored_quantity, 0);
  EXPECT_TRUE(loaded.value->facts[0].unfolded);
  EXPECT_NEAR(extent_mm(piece).width, 400, 1e-6);
  EXPECT_TRUE(piece.grainline);
  EXPECT_EQ(piece.drill_holes.size(), 2u);  // both halves
  EXPECT_EQ(piece.internal_lines.size(), 0u);
}

TEST(SvgRead, ShortLinesOnTheOutlineAreNotches) {
  const PatternFile file = value_of(
      svg_mm("<path d='M100,100 h200 v400 h-200 z'/><path stroke='black' d='M100,300 h5'/>"
             "<path stroke='black' fill='none' d='M298,200 l2,-2'/><path fill='none' stroke='black' d='M200,500 l3,-6 l3,6'/>"
             "<path stroke='black' d='M120,120 h5'/>"));
  const Piece& piece = file.pattern.pieces.at(0);
  ASSERT_EQ(piece.notches.size(), 3u);
  EXPECT_EQ(piece.internal_lines.size(), 1u);
  int v = 0;
  for (const Notch& notch : piece.notches) v += notch.kind == NotchKind::v && std::abs(notch.depth - .006) < 1e-6;
  EXPECT_EQ(v, 1);
}

TEST(SvgRead, FramesTestSquaresAndLegendsAreNoPieces) {
  const Loaded<PatternFile> loaded = read_text(svg_mm(
      "<rect x='1' y='1' width='998' height='998' fill='none' stroke='black'/>"
      "<rect x='20' y='20' width='50' height='50' fill='none' stroke='black'/><text x='25' y='40'>50 mm</text>"
      "<path d='M100,100 h200 v400 h-200 z'/><path d='M400,100 h200 v400 h-200 z'/><text x='800' y='900'>My pattern</text>"));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pattern.pieces.size(), 2u);
  EXPECT_TRUE(has_finding(loaded.report, "svg.outside"));
}

TEST(SvgRead, DartsAreNamed) {
  const Loaded<PatternFile> loaded =
      read_text(svg_mm("<path d='M100,100 H180 L190,200 L200,100 H300 V500 H100 Z'/><path fill='none' stroke='red' d='M240,300 "
                       "l8,60 l-8,60 l-8,-60 z'/>"));
  ASSERT_TRUE(loaded.value);
  const Piece& piece = loaded.value->pattern.pieces.at(0);
  ASSERT_TRUE(find_edge(piece, "dart1a"));
  ASSERT_TRUE(find_edge(piece, "dart1b"));
  EXPECT_NEAR(length(*find_edge(piece, "dart1a")), std::hypot(.01, .1), 1e-9);
  EXPECT_EQ(piece.internal_lines.size(), 1u);
  EXPECT_TRUE(has_finding(loaded.report, "svg.darts"));
}

TEST(SvgRead, NothingDrawnIsSilentlyLost) {
  const Loaded<PatternFile> loaded =
      read_text(svg_mm("<path d='M100,100 h200 v400 h-200 z'/><image href='x.png' width='10' height='10'/><path stroke='black' "
                       "d='M600,600 h50'/><use href='#gone'/>"));
  ASSERT_TRUE(loaded.value);
  std::string said;
  for (const Finding& finding : loaded.report.findings) said += in_words(finding) + "\n";
  EXPECT_NE(said.find("left out: 1 pictures"), std::string::npos) << said;
  EXPECT_NE(said.find("left out: 1 lines"), std::string::npos) << said;
  EXPECT_NE(said.find("left out: 1 uses of what is not in the file"), std::string::npos) << said;
}

TEST(SvgRead, ReadsByExtensionAndContent) {
  const test::Folder folder;
  write_whole_file(folder / "a.svg", svg_mm("<path d='" + skirt + "'/>"));
  write_whole_file(folder / "b.xml", svg_mm("<path d='" + skirt + "'/>"));
  for (const char* name : {"a.svg", "b.xml"}) {
    const Loaded<PatternFile> loaded = read_pattern_file(folder / name);
    ASSERT_TRUE(loaded.value) << name;
    EXPECT_EQ(loaded.value->format, "SVG");
  }
}

TEST(SvgWords, QuantitiesInSeveralLanguages) {
  struct Case {
    const char* words;
    int copies;
    bool mirrored, fold;
  };
  for (const Case& c :
       {Case{"Cut 2", 2, false, false}, Case{"Cut 2 (1 pair)", 2, true, false}, Case{"CUT 1 ON FOLD", 1, false, true},
        Case{"plugin-annotations:cut,2,plugin-annotations:mirrored,plugin-annotations:from,plugin-annotations:fabric,", 2, true,
             false},
        Case{"plugin-annotations:cut,1,plugin-annotations:onFold,", 1, false, true}, Case{"2x zuschneiden", 2, false, false},
        Case{"1 x im Stoffbruch", 1, false, true}, Case{"4x gegengleich", 4, true, false},
        Case{"Couper 2 fois", 2, false, false}, Case{"couper 1 fois au pli", 1, false, true}, Case{"Cortar 2", 2, false, false},
        Case{"Tagliare 2 volte", 2, false, false}, Case{"Fabric, Cut 2", 2, false, false}, Case{"1 pair", 2, true, false}}) {
    const std::optional<svg::CutText> text = svg::cut_text(c.words);
    ASSERT_TRUE(text) << c.words;
    EXPECT_EQ(text->copies, c.copies) << c.words;
    EXPECT_EQ(text->mirrored, c.mirrored) << c.words;
    EXPECT_EQ(text->on_fold, c.fold) << c.words;
  }
  for (const char* words : {"Front", "Size 12", "Saturday, Nov 21, 2026", "10 cm", "Penelope pencil skirt v4.10.2"})
    EXPECT_FALSE(svg::cut_text(words)) << words;
}

}  // namespace
}  // namespace toile
