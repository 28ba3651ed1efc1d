// What DXF files hold beside polylines in blocks: curves, nested blocks, flat drawings, markers.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"
#include "formats/formats.h"

namespace toile {
namespace {

constexpr double pi = std::numbers::pi;
const std::string name = text_on("1", "Piece Name: front");

Loaded<PatternFile> read(const std::string& bytes) { return read_dxf_pattern_bytes(bytes, "zoo.dxf", {}); }
PatternFile file_of(const std::string& bytes) {
  Loaded<PatternFile> loaded = read(bytes);
  EXPECT_TRUE(loaded.value) << all_words(loaded.report);
  return loaded.value.value_or(PatternFile{});
}
double area_of(const std::string& outline) {
  const PatternFile file = file_of(pattern_file(block("A", name + outline)));
  return file.pattern.pieces.empty() ? 0 : signed_area(file.pattern.pieces[0]) * 1e6;
}
std::string flat(const std::string& entities, const std::string& header = tag(9, "$INSUNITS") + tag(70, "4")) {
  return section("HEADER", header) + section("ENTITIES", entities) + tag(0, "EOF");
}
std::string arc(double x, double y, double r, double from, double to, const std::string& more = {}) {
  return tag(0, "ARC") + tag(8, "1") + tag(10, std::to_string(x)) + tag(20, std::to_string(y)) + tag(40, std::to_string(r)) +
         tag(50, std::to_string(from)) + tag(51, std::to_string(to)) + more;
}

TEST(DxfZoo, ArcsAndLinesMakeAnOutline) {  // a half circle over a straight hem; chords are within 0.05 mm
  EXPECT_NEAR(area_of(arc(0, 0, 200, 0, 180) + line_on("1", {-200, 0}, {200, 0})), pi * 200 * 200 / 2, .05 * 200 * pi);
  // The same seen from below: the arc of the upper half in mirrored coordinates.
  EXPECT_NEAR(area_of(arc(0, 0, 200, 0, 180, tag(230, "-1")) + line_on("1", {-200, 0}, {200, 0})), pi * 200 * 200 / 2,
              .05 * 200 * pi);
}

TEST(DxfZoo, CirclesAndEllipsesAreOutlines) {
  const std::string circle = tag(0, "CIRCLE") + tag(8, "1") + tag(10, "5") + tag(20, "5") + tag(40, "250");
  EXPECT_NEAR(area_of(circle), pi * 250 * 250, .05 * 2 * pi * 250);
  const std::string ellipse = tag(0, "ELLIPSE") + tag(8, "1") + tag(10, "0") + tag(20, "0") + tag(11, "300") + tag(21, "0") +
                              tag(40, "0.5") + tag(41, "0") + tag(42, "6.283185307179586");
  EXPECT_NEAR(area_of(ellipse), pi * 300 * 150, .05 * 2 * pi * 300);
}

TEST(DxfZoo, SplinesAreReadByTheirControlPointsOrThroughTheirFitPoints) {
  // A parabola as one quadratic span: two thirds of the box under it.
  const std::string spline = tag(0, "SPLINE") + tag(8, "1") + tag(70, "8") + tag(71, "2") + tag(40, "0") + tag(40, "0") +
                             tag(40, "0") + tag(40, "1") + tag(40, "1") + tag(40, "1") + tag(10, "0") + tag(20, "0") +
                             tag(10, "200") + tag(20, "600") + tag(10, "400") + tag(20, "0");
  EXPECT_NEAR(area_of(spline + line_on("1", {400, 0}, {0, 0})), 400 * 300 * 2 / 3., .05 * 1000);
  std::string fit = tag(0, "SPLINE") + tag(8, "1") + tag(71, "3");
  for (int i = 0; i <= 12; ++i)
    fit += tag(11, std::to_string(200 * std::cos(pi * i / 12))) + tag(21, std::to_string(200 * std::sin(pi * i / 12)));
  EXPECT_NEAR(area_of(fit + line_on("1", {-200, 0}, {200, 0})), pi * 200 * 200 / 2, 200);
  // Knots that do not fit are no spline, and are said to be none.
  const Loaded<PatternFile> odd =
      read(pattern_file(block("A", polyline_on("1", rectangle(0, 0, 400, 600), true) + tag(0, "SPLINE") + tag(8, "8") +
                                       tag(71, "3") + tag(10, "0") + tag(20, "0"))));
  EXPECT_TRUE(find(odd.report, "aama.unsupported-entity"));
}

TEST(DxfZoo, BlocksInBlocksArePutIn) {
  const std::string pocket = block("POCKET", polyline_on("0", rectangle(0, 0, 50, 40), true));
  const std::string front =
      block("FRONT", name + polyline_on("1", rectangle(0, 0, 400, 600), true) + tag(0, "INSERT") + tag(8, "8") +
                         tag(2, "POCKET") + tag(10, "100") + tag(20, "200") + tag(41, "2") + tag(50, "90"));
  const PatternFile file = file_of(pattern_file(pocket + front));
  ASSERT_EQ(file.pattern.pieces.size(), 1u);
  ASSERT_EQ(file.pattern.pieces[0].internal_lines.size(), 1u);
  EXPECT_LT((file.pattern.pieces[0].internal_lines[0].points[1] * 1e3 - Eigen::Vector2d(100, 300)).norm(), 1e-9);
}

TEST(DxfZoo, ABlockThatContainsItselfEnds) {
  const std::string self = block("A", name + polyline_on("1", rectangle(0, 0, 400, 600), true) + tag(0, "INSERT") +
                                          tag(8, "1") + tag(2, "A") + tag(10, "0") + tag(20, "0"));
  EXPECT_TRUE(read(pattern_file(self)).report.findings.size() > 0);
  std::string bomb;  // 8^20 lines
  for (int i = 0; i < 20; ++i) {
    std::string inserts = i == 0 ? polyline_on("1", rectangle(0, 0, 400, 600), true) : "";
    for (int k = 0; k < 8; ++k) inserts += tag(0, "INSERT") + tag(8, "1") + tag(2, "B" + std::to_string(i + 1));
    bomb += block("B" + std::to_string(i), inserts);
  }
  const Loaded<PatternFile> loaded = read(pattern_file(bomb));
  EXPECT_FALSE(loaded.value);
  EXPECT_TRUE(find(loaded.report, "dxf.too-large"));
}

TEST(DxfZoo, AFlatDrawingHasAPieceForEachOuterLine) {
  const std::string drawing = polyline_on("0", rectangle(0, 0, 420, 620), true) +
                              polyline_on("0", rectangle(10, 10, 410, 610), true) + text_on("0", "Front", {200, 300}) +
                              polyline_on("0", rectangle(500, 0, 900, 600), true) + line_on("0", {600, 100}, {600, 500}) +
                              line_on("0", {2000, 0}, {2000, 9});
  const Loaded<PatternFile> loaded = read(flat(drawing));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_TRUE(find(loaded.report, "aama.flat-drawing"));
  EXPECT_TRUE(find(loaded.report, "aama.outside-pieces"));
  EXPECT_EQ(loaded.value->dialect, "AutoCAD drawing");
  EXPECT_EQ(loaded.value->units.decided_by, "$INSUNITS");
  ASSERT_EQ(loaded.value->pattern.pieces.size(), 2u);
  EXPECT_EQ(loaded.value->pattern.pieces[0].name, "Front");
  EXPECT_FALSE(find(loaded.report, "aama.style-text"));
  EXPECT_NEAR(signed_area(loaded.value->pattern.pieces[0]), .4 * .6, 1e-9);  // the inner line is the sew line
  EXPECT_EQ(loaded.value->facts[0].sew_line_source, "layer 8");
  EXPECT_EQ(loaded.value->pattern.pieces[1].internal_lines.size(), 1u);
}

TEST(DxfZoo, AMarkerKeepsItsLayersAndLosesItsFrame) {
  std::string marker = polyline_on("1", rectangle(-50, -50, 1500, 900), true);
  for (const double x : {0.0, 600.0})
    marker += polyline_on("1", rectangle(x, 0, x + 400, 600), true) + line_on("7", {x + 50, 50}, {x + 50, 500}) +
              point_on("4", {x + 200, 0}) + text_on("1", "Piece Name: P" + std::to_string(static_cast<int>(x)), {x + 10, 10});
  const Loaded<PatternFile> loaded = read(flat(marker));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_TRUE(find(loaded.report, "aama.sheet-frame"));
  ASSERT_EQ(loaded.value->pattern.pieces.size(), 2u);
  for (const Piece& piece : loaded.value->pattern.pieces) {
    EXPECT_NEAR(signed_area(piece), .24, 1e-9);
    EXPECT_TRUE(piece.grainline);
    EXPECT_EQ(piece.notches.size(), 1u);
  }
  EXPECT_EQ(loaded.value->pattern.pieces[1].name, "P600");
}

TEST(DxfZoo, OutlinesOfAFlatDrawingMayBeInPieces) {  // every line of its own, as drawing programs export
  const Xy a = rectangle(0, 0, 400, 600);
  std::string lines;
  for (std::size_t i = 0; i < 4; ++i) lines += line_on("0", a[i], a[(i + 1) % 4]);
  EXPECT_EQ(file_of(flat(lines + line_on("0", {0, 0}, {-80, 0}))).pattern.pieces.size(), 1u);
}

TEST(DxfZoo, SaysDialectAuthorAndUnits) {
  const std::string piece = block("A", name + polyline_on("1", rectangle(0, 0, 400, 600), true));
  const PatternFile astm =
      file_of(pattern_file(piece, {"Units: METRIC", "Author: us ; prog ; 2", "ASTM/D13Proposal 1 Version: D 6673-04"}));
  EXPECT_EQ(astm.format, "DXF");
  EXPECT_EQ(astm.dialect, "ASTM");
  EXPECT_EQ(astm.author, "us ; prog ; 2");
  EXPECT_EQ(astm.units, (FileUnits{"mm", 1e-3, "text"}));
  const PatternFile aama = file_of(pattern_file(piece, {"Units: METRIC", "Author: us", "PRODUCT: prog", "VERSION: 2"}));
  EXPECT_EQ(aama.dialect, "AAMA");
  EXPECT_EQ(aama.author, "us ; prog ; 2");
  ASSERT_EQ(aama.facts.size(), 1u);
  EXPECT_FALSE(aama.facts[0].has_sew_line);
  EXPECT_EQ(aama.facts[0].sew_line_source, "cut line");
}

TEST(DxfZoo, AnOutlineOfTooManyPointsIsNamed) {
  Xy many;
  for (int i = 0; i < 20'001; ++i) many.emplace_back(300 * std::cos(2 * pi * i / 20'001), 300 * std::sin(2 * pi * i / 20'001));
  const Loaded<PatternFile> loaded = read(pattern_file(block("A", name + polyline_on("1", many, true))));
  EXPECT_FALSE(loaded.value);
  ASSERT_TRUE(find(loaded.report, "dxf.too-large"));
  EXPECT_NE(find(loaded.report, "dxf.too-large")->place.find("piece 'front'"), std::string::npos);
}

TEST(DxfZoo, HugeCoordinatesAndNoNumbersAreNamed) {
  for (const char* bad : {"1e308", "nan", "-inf", "1e10"}) {
    const Loaded<PatternFile> loaded = read(
        pattern_file(block("A", tag(0, "LINE") + tag(8, "1") + tag(10, bad) + tag(20, "0") + tag(11, "1") + tag(21, "1"))));
    EXPECT_TRUE(find(loaded.report, "dxf.not-a-number")) << bad;
    const Loaded<PatternFile> curve = read(pattern_file(block("A", arc(0, 0, 1, 0, 90) + tag(40, bad))));
    EXPECT_TRUE(find(curve.report, "dxf.not-a-number")) << bad;
  }
}

}  // namespace
}  // namespace toile
