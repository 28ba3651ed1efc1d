#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/dxf/drawing.h"
#include "formats/dxf/tag_writer.h"
#include "formats/dxf/tags.h"
#include "formats/dxf_text.h"

namespace toile::dxf {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) text.replace(at, what.size(), by);
  return text;
}

std::string one_line_file() { return section("ENTITIES", line_on("7", {1, 2}, {3, 4})) + tag(0, "EOF"); }

const Finding& only_error(const Loaded<Drawing>& loaded) {
  static const Finding none;
  EXPECT_FALSE(loaded.value);
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error) return finding;
  ADD_FAILURE() << "no error";
  return none;
}

TEST(DxfTags, AreReadWithLineNumbersWhateverThePaddingAndLineEnds) {
  const std::string plain = "0\nLINE\n  8\n 7 \n";
  for (const std::string& text : {plain, replaced(plain, "\n", "\r\n"), replaced(plain, "\n", "\r"), "\xEF\xBB\xBF" + plain,
                                  plain + "\n\n", plain + "\x1a"}) {
    const auto tags = read_tags(text, "x.dxf");
    ASSERT_TRUE(tags.value) << all_words(tags.report);
    ASSERT_EQ(tags.value->size(), 2u);
    EXPECT_EQ((*tags.value)[0].code, 0);
    EXPECT_EQ((*tags.value)[0].value, "LINE");
    EXPECT_EQ((*tags.value)[1].code, 8);
    EXPECT_EQ((*tags.value)[1].value, "7");
    EXPECT_EQ((*tags.value)[1].line, 3);
  }
}

TEST(DxfTags, DropCommentsButCountTheirLines) {
  const auto tags = read_tags("999\nmade by hand\n0\nEOF\n", "x.dxf");
  ASSERT_TRUE(tags.value);
  ASSERT_EQ(tags.value->size(), 1u);
  EXPECT_EQ(tags.value->front().line, 3);
}

TEST(DxfTags, SayWhatIsNoDxf) {
  EXPECT_TRUE(find(read_tags("AutoCAD Binary DXF\r\n\x1a", "x.dxf").report, "dxf.binary"));
  EXPECT_TRUE(find(read_tags("<svg/>", "x.dxf").report, "dxf.not-dxf"));
  EXPECT_TRUE(find(read_tags("", "x.dxf").report, "dxf.not-dxf"));
  const auto broken = read_tags("0\nSECTION\n2x\nENTITIES\n", "x.dxf");
  ASSERT_TRUE(find(broken.report, "dxf.broken-tag"));
  EXPECT_EQ(find(broken.report, "dxf.broken-tag")->place, "x.dxf:3");
  EXPECT_TRUE(find(read_tags("0\nSECTION\n2\n", "x.dxf").report, "dxf.truncated"));
}

TEST(DxfNumbers, AreFiniteAndOfCoordinateSize) {
  EXPECT_EQ(number(" +1.5 "), 1.5);
  EXPECT_EQ(number("-.0000"), 0.0);
  EXPECT_EQ(number("1e-3"), 1e-3);
  for (const char* bad : {"", "nan", "inf", "-inf", "1,5", "1.5mm", "1e400", "2e9", "0x10"}) EXPECT_FALSE(number(bad)) << bad;
}

TEST(DxfDrawing, HoldsBlocksEntitiesAndHeader) {
  const std::string text =
      tag(9, "$ACADVER") + tag(1, "AC1009") + section("HEADER", tag(9, "$INSUNITS") + tag(70, "4")) +
      section("TABLES", tag(0, "TABLE") + tag(2, "LAYER") + tag(0, "ENDTAB")) +
      section("BLOCKS", block("FRONT", point_on("4", {1, 2}, tag(30, "3") + tag(39, "2") + tag(50, "90")))) +
      section("ENTITIES", tag(0, "INSERT") + tag(8, "1") + tag(2, "FRONT") + tag(10, "5") + tag(20, "6") + tag(41, "2") +
                              tag(50, "30") + text_on("1", "Style Name: a")) +
      tag(0, "EOF");
  const auto loaded = read_drawing(text, "x.dxf");
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_EQ(loaded.value->header.at("$ACADVER"), "AC1009");
  EXPECT_EQ(loaded.value->header.at("$INSUNITS"), "4");
  ASSERT_EQ(loaded.value->blocks.size(), 1u);
  const Entity& point = loaded.value->blocks[0].entities.at(0);
  EXPECT_EQ(point.kind, Kind::point);
  EXPECT_EQ(point.layer, "4");
  EXPECT_EQ(point.points[0], Eigen::Vector2d(1, 2));
  EXPECT_EQ(point.z, 3);
  EXPECT_EQ(point.thickness, 2);
  EXPECT_EQ(point.angle, 90);
  const Entity& insert = loaded.value->entities.at(0);
  EXPECT_EQ(insert.text, "FRONT");
  EXPECT_EQ(insert.points[0], Eigen::Vector2d(5, 6));
  EXPECT_EQ(insert.scale, Eigen::Vector2d(2, 1));
  EXPECT_EQ(loaded.value->entities.at(1).text, "Style Name: a");
}

TEST(DxfDrawing, ReadsOldAndLightPolylinesAlike) {
  const std::string light = tag(0, "LWPOLYLINE") + tag(8, "1") + tag(90, "3") + tag(70, "1") + tag(10, "0") + tag(20, "0") +
                            tag(42, "0.5") + tag(10, "2") + tag(20, "0") + tag(10, "2") + tag(20, "1");
  const std::string old = tag(0, "POLYLINE") + tag(8, "1") + tag(66, "1") + tag(70, "1") + tag(10, "9") + tag(20, "9") +
                          tag(0, "VERTEX") + tag(10, "0") + tag(20, "0") + tag(42, "0.5") + tag(0, "VERTEX") + tag(10, "2") +
                          tag(20, "0") + tag(0, "VERTEX") + tag(10, "2") + tag(20, "1") + tag(0, "SEQEND") + tag(8, "1");
  const auto loaded = read_drawing(section("ENTITIES", light + old) + tag(0, "EOF"), "x.dxf");
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  ASSERT_EQ(loaded.value->entities.size(), 2u);
  for (const Entity& entity : loaded.value->entities) {
    EXPECT_TRUE(entity.closed);
    EXPECT_EQ(entity.points, (std::vector<Eigen::Vector2d>{{0, 0}, {2, 0}, {2, 1}}));
    EXPECT_EQ(entity.bulges, (std::vector<double>{0.5, 0, 0}));
  }
}

TEST(DxfDrawing, TakesAPolylineWithoutSeqend) {
  const std::string open = tag(0, "POLYLINE") + tag(8, "1") + tag(0, "VERTEX") + tag(10, "0") + tag(20, "0") +
                           tag(0, "VERTEX") + tag(10, "1") + tag(20, "0") + line_on("7", {0, 0}, {0, 1});
  const auto loaded = read_drawing(section("ENTITIES", open) + tag(0, "EOF"), "x.dxf");
  ASSERT_TRUE(loaded.value);
  ASSERT_EQ(loaded.value->entities.size(), 2u);
  EXPECT_EQ(loaded.value->entities[0].points.size(), 2u);
}

TEST(DxfDrawing, NamesTheLineOfACoordinateThatIsNone) {
  const auto loaded = read_drawing(replaced(one_line_file(), "3.0000", "nan"), "x.dxf");
  const Finding& error = only_error(loaded);
  EXPECT_EQ(error.code, "dxf.not-a-number");
  EXPECT_EQ(error.place, "x.dxf:14");
  EXPECT_NE(error.text.find("layer 7"), std::string::npos);
}

TEST(DxfDrawing, RefusesAnEntityWithoutItsCoordinates) {
  const auto loaded =
      read_drawing(section("ENTITIES", tag(0, "LINE") + tag(8, "7") + tag(10, "1") + tag(20, "1")) + tag(0, "EOF"), "x.dxf");
  EXPECT_EQ(only_error(loaded).code, "dxf.incomplete-entity");
}

TEST(DxfDrawing, TellsACutOffFileFromOneWithoutTheEofMark) {
  const std::string whole = one_line_file();
  const std::string no_mark = whole.substr(0, whole.find("  0\nEOF"));
  const auto loaded = read_drawing(no_mark, "x.dxf");
  EXPECT_TRUE(loaded.value);
  EXPECT_TRUE(find(loaded.report, "dxf.no-eof"));
  EXPECT_EQ(only_error(read_drawing(no_mark.substr(0, no_mark.find("  0\nENDSEC")), "x.dxf")).code, "dxf.truncated");
  EXPECT_EQ(only_error(read_drawing(section("BLOCKS", ""), "x.dxf")).code, "dxf.truncated");
}

TEST(DxfArcs, StayWithinTheChordAndOnTheCircle) {
  Entity half;
  half.kind = Kind::polyline;
  half.points = {{-100, 0}, {100, 0}};
  half.bulges = {-1, 0};  // clockwise half circle over the top
  for (const double chord : {10.0, 0.1, 0.001}) {
    const auto points = flattened(half, chord);
    ASSERT_GT(points.size(), 3u);
    double length = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(points[i].norm(), 100, 1e-9);
      EXPECT_GE(points[i].y(), -1e-9);
      if (i == 0) continue;
      EXPECT_LE(100 - ((points[i] + points[i - 1]) / 2).norm(), chord * 1.0001);
      length += (points[i] - points[i - 1]).norm();
    }
    EXPECT_NEAR(length, 100 * std::numbers::pi, 2 * chord * static_cast<double>(points.size()));
  }
  half.bulges = {std::tan(std::numbers::pi / 8), 0};  // a quarter, counter-clockwise: below the chord
  for (const auto& p : flattened(half, .1)) EXPECT_LE(p.y(), 1e-9);
}

TEST(DxfWriter, WritesFixedNumbersAndNoNegativeZero) {
  std::string out;
  put_number(out, 10, -0.00001);
  put_number(out, 1040, 1234.56789);
  EXPECT_EQ(out, " 10\n0.0000\n1040\n1234.5679\n");
  EXPECT_THROW(put_number(out, 10, std::nan("")), std::invalid_argument);
}

TEST(DxfWriter, IsReadBackByTheReader) {
  std::string members;
  put_polyline(members, "1", {{0, 0}, {1, 0}, {1, 2}}, true);
  put_line(members, "7", {0, 0}, {0, 1});
  put_text(members, "1", {1, 1}, 5, "Piece Name: front");
  put_insert(members, "1", "FRONT");
  std::string file;
  put_section(file, "ENTITIES");
  file += members;
  put_section_end(file);
  put(file, 0, "EOF");
  const auto loaded = read_drawing(file, "x.dxf");
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_TRUE(loaded.report.findings.empty());
  ASSERT_EQ(loaded.value->entities.size(), 4u);
  EXPECT_EQ(loaded.value->entities[0].points, (std::vector<Eigen::Vector2d>{{0, 0}, {1, 0}, {1, 2}}));
  EXPECT_TRUE(loaded.value->entities[0].closed);
  EXPECT_EQ(loaded.value->entities[2].text, "Piece Name: front");
  EXPECT_EQ(loaded.value->entities[3].text, "FRONT");
}

}  // namespace
}  // namespace toile::dxf
