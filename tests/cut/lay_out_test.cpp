#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "pieces.h"

namespace toile {
namespace {

using namespace testing;
using Eigen::Vector2d;

Vector2d on_page(const PlacedPiece& placed, const Vector2d& p) {
  const double c = std::cos(placed.turn), s = std::sin(placed.turn);
  return Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y()) + placed.shift;
}

Polygon cut_line_on_page(const PlacedPiece& placed) {
  Polygon line;
  for (const OutlinePoint& point : placed.cut.cut_line) line.push_back(on_page(placed, point.at));
  return line;
}

double distance_between(const Polygon& a, const Polygon& b) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      nearest = std::min(nearest, distance(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()]));
  return nearest;
}

Pattern many_pieces(int count) {
  std::mt19937 random(11);
  const auto pick = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 5) / (1U << 27U));
  };
  Pattern pattern;
  pattern.name = "many";
  for (int i = 0; i < count; ++i) {
    Piece made = i % 3 == 0   ? rectangle(pick(.05, .5), pick(.05, .6))
                 : i % 3 == 1 ? polygon_piece({{0, 0}, {pick(.2, .4), 0}, {pick(.1, .15), pick(.3, .6)}})
                              : polygon_piece({{0, 0}, {.3, 0}, {.3, .1}, {pick(.06, .2), .1}, {.05, pick(.2, .4)}, {0, .4}});
    made.name = "p" + std::to_string(i);
    const double angle = pick(-3, 3);
    made.grainline = Grainline{{.1, .1}, Vector2d(.1, .1) + .05 * Vector2d(std::cos(angle), std::sin(angle))};
    pattern.pieces.push_back(std::move(made));
  }
  return pattern;
}

TEST(LayOut, PiecesKeepClearOfEachOtherAndOfThePage) {
  const SheetRules rules;
  const CutSheet sheet = lay_out(many_pieces(24), rules);
  ASSERT_EQ(sheet.placed.size(), 24u);
  std::vector<Polygon> lines;
  double top = 0;
  for (const PlacedPiece& placed : sheet.placed) {
    lines.push_back(cut_line_on_page(placed));
    for (const Vector2d& p : lines.back()) {
      EXPECT_GE(p.minCoeff(), rules.margin - 1e-9);
      EXPECT_LE(p.x(), rules.width - rules.margin + 1e-9);
      top = std::max(top, p.y());
    }
  }
  EXPECT_NEAR(sheet.page_length, top + rules.margin, 1e-9);
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = i + 1; j < lines.size(); ++j) {
      EXPECT_FALSE(overlap(lines[i], lines[j])) << sheet.placed[i].cut.piece.name << " " << sheet.placed[j].cut.piece.name;
      EXPECT_GE(distance_between(lines[i], lines[j]), .7 * rules.gap);
    }
}

TEST(LayOut, GrainRunsAlongThePage) {
  for (const bool one_way : {false, true}) {
    SheetRules rules;
    rules.one_way = one_way;
    for (const PlacedPiece& placed : lay_out(many_pieces(12), rules).placed) {
      const Grainline& grain = *placed.cut.piece.grainline;
      const Vector2d d = (on_page(placed, grain.to) - on_page(placed, grain.from)).normalized();
      EXPECT_NEAR(d.x(), 0, 1e-12);
      EXPECT_TRUE(!one_way || d.y() > 0);
    }
  }
}

TEST(LayOut, UsesNearlyHalfOfThePageForAwkwardPieces) {
  const CutSheet sheet = lay_out(many_pieces(24));
  double area = 0;
  for (const PlacedPiece& placed : sheet.placed) area += signed_area(cut_line_on_page(placed));
  EXPECT_GT(area / (sheet.page_width * sheet.page_length), .48);
}

TEST(LayOut, TheSameTwice) { EXPECT_EQ(lay_out(many_pieces(9)), lay_out(many_pieces(9))); }

TEST(LayOut, DrawsAPieceOnceAndSaysHowOftenToCutIt) {
  Pattern pattern;
  pattern.style = "G8";
  pattern.sample_size = "38";
  pattern.fabric = "jersey";
  pattern.pieces = {rectangle(.2, .6)};
  pattern.pieces[0].quantity = 8;
  pattern.pieces[0].name = "gore";
  const CutSheet sheet = lay_out(pattern);
  ASSERT_EQ(sheet.placed.size(), 1u);
  const std::vector<std::string>& labels = sheet.placed[0].cut.labels;
  EXPECT_EQ(labels[0], "G8");
  EXPECT_EQ(labels[1], "gore, size 38");
  EXPECT_EQ(labels[2], "Cut 8");
  EXPECT_NE(std::find(labels.begin(), labels.end(), "Fabric: jersey"), labels.end());
  EXPECT_EQ(sheet.placed[0].cut.size, "38");
  EXPECT_EQ(sheet.title, "G8, size 38");
  pattern.style = "G8, size 38";
  EXPECT_EQ(lay_out(pattern).title, "G8, size 38");
}

TEST(LayOut, GivesAGrainLineWhereThereIsNone) {
  Pattern pattern;
  pattern.pieces = {rectangle(.2, .6)};
  const PlacedPiece placed = lay_out(pattern).placed.at(0);
  ASSERT_TRUE(placed.cut.piece.grainline);
  EXPECT_EQ(placed.cut.piece.grainline->from.x(), placed.cut.piece.grainline->to.x());
  EXPECT_NE(placed.cut.labels.back().find("none was given"), std::string::npos);
}

TEST(LayOut, SewnEdgesAreNoHems) {
  Pattern pattern;
  pattern.pieces = {rectangle(.2, .3)};
  Piece& only = pattern.pieces[0];
  for (Edge& e : only.outline) e.seam_allowance.reset();
  only.outline[0].id = "hem";
  only.outline[2].hem = true;
  const auto height = [](const CutSheet& sheet) { return sheet.page_length - 2 * SheetRules{}.margin; };
  EXPECT_NEAR(height(lay_out(pattern)), .3 + .03 + .03, 1e-9);
  Seam seam;
  seam.a = {.piece = "piece", .copy = 1, .edge = "hem"};
  seam.b = {.piece = "piece", .copy = 1, .edge = "e2"};
  pattern.seams = {seam};
  EXPECT_NEAR(height(lay_out(pattern)), .3 + .01 + .01, 1e-9);
}

TEST(LayOut, NamesThePieceThatIsTooWide) {
  Pattern pattern;
  pattern.pieces = {rectangle(1.6, .6)};
  pattern.pieces[0].name = "circle";
  try {
    lay_out(pattern);
    FAIL() << "wider than the page";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "cut.page-too-narrow");
    EXPECT_NE(bad.finding().place.find("circle"), std::string::npos);
  }
}

}  // namespace
}  // namespace toile
