#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <sstream>

#include "cut/cut.h"
#include "formats/folder.h"
#include "formats/formats.h"
#include "formats/svg/label_place.h"
#include "formats/svg/marks.h"
#include "formats/svg/write_svg.h"
#include "formats/svg/xml_text.h"
#include "formats/xml_tree.h"

namespace toile {
namespace {

using Eigen::Vector2d;
using test::all_with;
using test::Element;
using test::parse_xml;

Pattern skirt() {
  Pattern pattern;
  pattern.name = "Rock & <Rolle> \"6\"";
  pattern.sample_size = "38";
  Piece front;
  front.name = "front <A&B>";
  const std::vector<Vector2d> corners{{-.2, 0}, {.2, 0}, {.15, .5}, {-.15, .5}};
  const char* ids[] = {"hem", "right", "waist", "left"};
  for (std::size_t i = 0; i < 4; ++i) {
    Edge edge;
    edge.id = ids[i];
    edge.points = {{corners[i], true, {}}, {corners[(i + 1) % 4], true, {}}};
    front.outline.push_back(edge);
  }
  for (const NotchKind kind :
       {NotchKind::slit, NotchKind::v, NotchKind::t, NotchKind::castle, NotchKind::check, NotchKind::u}) {
    Notch notch;
    notch.edge = "right";
    notch.at = .1 + .1 * static_cast<double>(front.notches.size());
    notch.kind = kind;
    front.notches.push_back(notch);
  }
  front.grainline = Grainline{{0, .1}, {0, .4}};
  front.drill_holes = {{{.05, .3}, .004}};
  front.internal_lines = {{{{-.1, .2}, {-.05, .2}}, false}};
  Piece band;
  band.name = "band";
  for (const auto& [id, a, b] :
       {std::tuple{"a", Vector2d(0, 0), Vector2d(.04, 0)}, std::tuple{"b", Vector2d(.04, 0), Vector2d(.04, .6)},
        std::tuple{"c", Vector2d(.04, .6), Vector2d(0, .6)}, std::tuple{"d", Vector2d(0, .6), Vector2d(0, 0)}}) {
    Edge edge;
    edge.id = id;
    edge.points = {{a, true, {}}, {b, true, {}}};
    band.outline.push_back(edge);
  }
  pattern.pieces = {front, band};
  Seam seam;
  seam.name = "side";
  seam.a = {.piece = front.name, .copy = 1, .edge = "left"};
  seam.b = {.piece = front.name, .copy = 2, .edge = "right"};
  pattern.seams = {seam};
  return pattern;
}

CutSheet sheet(double width = 1.5) {
  SheetRules rules;
  rules.width = width;
  CutSheet made = lay_out(skirt(), rules);
  made.notes = {"re-drape to target: 0.8 mm mean"};
  return made;
}

// The points of a path of M and L, mm.
std::vector<Vector2d> points_of(const std::string& data) {
  std::vector<Vector2d> points;
  std::istringstream in(data);
  for (std::string word; in >> word;) {
    double x = 0, y = 0;
    if (std::sscanf(word.c_str(), "%lf,%lf", &x, &y) == 2) points.emplace_back(x, y);
  }
  return points;
}

std::vector<double> numbers_of(const std::string& words) {
  std::istringstream in(words);
  std::vector<double> numbers;
  for (double number; in >> number;) numbers.push_back(number);
  return numbers;
}

TEST(Svg, OneUserUnitIsOneMillimetre) {
  for (const double width : {1.5, .9, .5}) {
    const CutSheet cut = sheet(width);
    const Element root = parse_xml(svg_text(cut));
    EXPECT_EQ(root.name, "svg");
    const std::vector<double> box = numbers_of(root.get("viewBox"));
    ASSERT_EQ(box.size(), 4u);
    EXPECT_EQ(box[0], 0);
    EXPECT_EQ(box[1], 0);
    EXPECT_EQ(root.get("width"), in_digits(box[2]) + "mm");
    EXPECT_EQ(root.get("height"), in_digits(box[3]) + "mm");
    EXPECT_NEAR(box[2], 1000 * width, 1e-3);
    EXPECT_GT(box[3], 1000 * cut.page_length);
  }
}

TEST(Svg, PiecesHaveTheirTrueSize) {
  const Element root = parse_xml(svg_text(sheet()));
  const auto cut = all_with(root, "data-type", "cut");
  ASSERT_EQ(cut.size(), 2u);
  std::vector<Vector2d> line = points_of(cut[1].get("d"));  // placed second: the front
  if (cut[1].get("data-piece") != "front <A&B>") line = points_of(cut[0].get("d"));
  double low = INFINITY, high = -INFINITY;
  for (const Vector2d& p : line) low = std::min(low, p.y()), high = std::max(high, p.y());
  EXPECT_NEAR(high - low, 500 + 10 + 30, 2e-3);
  for (const Element& sew : all_with(root, "data-edge", "hem"))
    if (sew.get("data-type") == "sew") {
      const std::vector<Vector2d> ends = points_of(sew.get("d"));
      ASSERT_EQ(ends.size(), 2u);
      EXPECT_NEAR((ends[1] - ends[0]).norm(), 400, 2e-3);
    }
}

TEST(Svg, EveryLineSaysWhatItIs) {
  const Element root = parse_xml(svg_text(sheet()));
  EXPECT_EQ(all_with(root, "data-type", "piece").size(), 2u);
  EXPECT_EQ(all_with(root, "data-type", "sew").size(), 8u);
  EXPECT_EQ(all_with(root, "data-type", "notch").size(), 6u);
  EXPECT_EQ(all_with(root, "data-type", "grain").size(), 4u);  // a line and its heads, on both pieces
  EXPECT_EQ(all_with(root, "data-type", "drill").size(), 1u);
  EXPECT_EQ(all_with(root, "data-type", "internal").size(), 1u);
  EXPECT_EQ(all_with(root, "data-type", "turn").size(), 0u);
  for (const Element& sew : all_with(root, "data-type", "sew")) {
    EXPECT_FALSE(sew.get("data-edge").empty());
    EXPECT_FALSE(sew.get("data-piece").empty());
    EXPECT_FALSE(sew.get("stroke-dasharray").empty());
    const std::string edge = sew.get("data-edge");
    EXPECT_EQ(sew.get("data-seam"), edge == "left" ? "side/a" : edge == "right" ? "side/b" : "") << edge;
  }
  for (const Element& notch : all_with(root, "data-type", "notch")) EXPECT_EQ(notch.get("data-edge"), "right");
  for (const Element& cut : all_with(root, "data-type", "cut")) EXPECT_EQ(cut.get("stroke-dasharray"), "");
  SheetStyle with_turns;
  with_turns.turn_points.shown = true;
  EXPECT_EQ(all_with(parse_xml(svg_text(sheet(), with_turns)), "data-type", "turn").size(), 16u);
}

TEST(Svg, NamesComeThroughWhateverTheyHold) {
  const std::string text = svg_text(sheet());
  const Element root = parse_xml(text);
  EXPECT_EQ(all_with(root, "data-piece", "front <A&B>").front().name, "g");
  CutSheet odd = sheet();
  odd.title = std::string("bell\x07 broken\xff umlaut \xc3\xa4 kana \xe3\x81\x82");
  const Element title = parse_xml(svg_text(odd)).children.front();
  EXPECT_EQ(title.text, "bell? broken? umlaut \xc3\xa4 kana \xe3\x81\x82");
}

TEST(Svg, TestSquaresMeasureWhatTheySay) {
  for (const double width : {1.5, .5}) {
    const Element root = parse_xml(svg_text(sheet(width)));
    const auto squares = all_with(root, "data-type", "test-square");
    ASSERT_EQ(squares.size(), 2u);
    EXPECT_EQ(squares[0].get("width"), "50");
    EXPECT_EQ(squares[0].get("height"), "50");
    EXPECT_EQ(squares[1].get("width"), "50.8");
    const double page = numbers_of(root.get("viewBox"))[2];
    for (const Element& square : squares) EXPECT_LE(std::stod(square.get("x")) + std::stod(square.get("width")), page);
  }
}

TEST(Svg, LabelsLieInsideTheirPieces) {
  const Element root = parse_xml(svg_text(sheet()));
  const auto labels = all_with(root, "data-type", "label");
  ASSERT_EQ(labels.size(), 2u);
  EXPECT_NE(labels[0].children.size(), 0u);
  for (const Element& label : labels)
    for (const Element& words : label.children) EXPECT_GE(std::stod(words.get("font-size")), 2);
}

TEST(Svg, TheSameSheetTheSameBytes) { EXPECT_EQ(svg_text(sheet()), svg_text(sheet())); }

TEST(Svg, WritesNoEmptyAndNoBrokenFile) {
  const test::Folder folder;
  EXPECT_THROW(write_svg(folder / "empty.svg", CutSheet{}), BadInput);
  CutSheet broken = sheet();
  broken.placed[0].cut.cut_line[0].at.x() = NAN;
  EXPECT_THROW(write_svg(folder / "broken.svg", broken), std::invalid_argument);
  EXPECT_TRUE(folder.entries() == 0);
  write_svg(folder / "skirt.svg", sheet());
  EXPECT_EQ(test::contents(folder / "skirt.svg"), svg_text(sheet()));
}

std::string output_of(const std::string& command) {
  std::string output;
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return output;
  char buffer[256];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
  pclose(pipe);
  return output;
}

TEST(Svg, InkscapeOpensItAtTheRightSize) {
  if (output_of("command -v inkscape").empty()) GTEST_SKIP() << "inkscape is not installed";
  const test::Folder folder;
  write_svg(folder / "skirt.svg", sheet());
  const std::vector<double> box = numbers_of(parse_xml(svg_text(sheet())).get("viewBox"));
  const auto query = [&](const std::string& what) {
    return std::strtod(output_of("inkscape --query-" + what + " '" + (folder / "skirt.svg").string() + "' 2>/dev/null").c_str(),
                       nullptr);
  };
  EXPECT_NEAR(query("width") * 25.4 / 96, box[2],
              .5);  // Inkscape answers in pixels of 1/96 in; the page rectangle is the largest
  EXPECT_NEAR(query("height") * 25.4 / 96, box[3], .5);
}

TEST(Svg, RsvgDrawsItAtTheRightSize) {
  if (output_of("command -v rsvg-convert").empty()) GTEST_SKIP() << "rsvg-convert is not installed";
  const test::Folder folder;
  write_svg(folder / "skirt.svg", sheet());
  const std::string png = (folder / "skirt.png").string();
  output_of("rsvg-convert -d 25.4 -p 25.4 -o '" + png + "' '" + (folder / "skirt.svg").string() + "'");
  const std::string bytes = test::contents(png);
  ASSERT_GT(bytes.size(), 24u);
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  const std::vector<double> box = numbers_of(parse_xml(svg_text(sheet())).get("viewBox"));
  EXPECT_NEAR(number(16), box[2], 1.5);  // one pixel is one millimetre
  EXPECT_NEAR(number(20), box[3], 1.5);
}

TEST(SvgNumbers, AreShortAndFinite) {
  EXPECT_EQ(in_digits(1.5), "1.5");
  EXPECT_EQ(in_digits(-0.0001), "0");
  EXPECT_EQ(in_digits(12.3456), "12.346");
  EXPECT_EQ(in_digits(1500), "1500");
  EXPECT_THROW(in_digits(INFINITY), std::invalid_argument);
}

TEST(SvgMarks, NotchesPointInwardsByTheirDepth) {
  Notch slit;
  slit.depth = .004;
  EXPECT_EQ(notch_path({10, 20}, {0, -1}, slit), "M 10,20 L 10,16");
  slit.depth = 0;  // a mark outside
  EXPECT_EQ(notch_path({10, 20}, {0, -1}, slit), "M 10,20 L 10,23");
  Notch v;
  v.kind = NotchKind::v;
  v.depth = .005;
  v.width = .004;
  EXPECT_EQ(notch_path({0, 0}, {1, 0}, v), "M 0,-2 L 5,0 L 0,2");
}

TEST(LabelPlace, FillsARectangleAndTurnsInANarrowOne) {
  const LabelPlace wide = place_label({{0, 0}, {100, 0}, {100, 50}, {0, 50}}, {}, 10, 4, 100);
  EXPECT_TRUE(wide.upright);
  EXPECT_GT(wide.scale, 9);
  EXPECT_LE(wide.scale, 10);
  const LabelPlace narrow = place_label({{0, 0}, {10, 0}, {10, 200}, {0, 200}}, {}, 10, 2, 100);
  EXPECT_FALSE(narrow.upright);
  EXPECT_GT(narrow.scale, 4.5);
  EXPECT_EQ(place_label({{0, 0}, {100, 0}, {100, 50}, {0, 50}}, {}, 10, 4, 3).scale, 3);
}

TEST(LabelPlace, KeepsClearOfOutlineAndObstacles) {
  const std::vector<Vector2d> ell{{0, 0}, {100, 0}, {100, 30}, {30, 30}, {30, 100}, {0, 100}};
  const Segment2 line{{50, -10}, {50, 110}};
  const LabelPlace place = place_label(ell, {line}, 10, 5, 100);
  ASSERT_GT(place.scale, 2);
  const Vector2d half = place.scale * (place.upright ? Vector2d(5, 2.5) : Vector2d(2.5, 5));
  const Vector2d low = place.centre - half, high = place.centre + half;
  EXPECT_TRUE(low.minCoeff() >= 0);
  EXPECT_TRUE(high.x() <= 30 || high.y() <= 30);
  EXPECT_TRUE(high.x() < 50 || low.x() > 50);
}

}  // namespace
}  // namespace toile
