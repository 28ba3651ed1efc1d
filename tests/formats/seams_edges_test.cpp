#include <gtest/gtest.h>

#include "formats/seams/seams.h"
#include "formats/seams/span_text.h"
#include "formats/seams_skirt.h"

namespace toile {
namespace {

TEST(SpanText, ReadsPiecesCopiesEdgesAndRuns) {
  EXPECT_EQ(parse_span("gore:1.right"), (SpanText{"gore", 1, "right", {0, false}, {1, false}}));
  EXPECT_EQ(parse_span("band.bottom[0..1/8]"), (SpanText{"band", {}, "bottom", {0, false}, {.125, false}}));
  EXPECT_EQ(parse_span(" FRONT 1.5 : 2 . side seam [ 5 cm .. end ]"),
            (SpanText{"FRONT 1.5", 2, "side seam", {.05, true}, {1, false}}));
  EXPECT_EQ(parse_span("BK:R-32.e1"), (SpanText{"BK:R-32", {}, "e1", {0, false}, {1, false}}));
  EXPECT_EQ(parse_span("band.top[25 %..0.5]"), (SpanText{"band", {}, "top", {.25, false}, {.5, false}}));
}

TEST(SpanText, RefusesWhatIsNoRun) {
  for (const char* text : {"", "gore", "gore.", ".right", "gore.right[", "gore.right[0..]", "gore.right[0-1]",
                           "gore.right[1/0..1]", "gore.right[5..x]", "gore.right]"})
    EXPECT_FALSE(parse_span(text)) << text;
}

TEST(NameEdges, CountsFromTheCornerInWords) {
  const Pattern pattern = applied(pieces);
  const Piece& gore = pattern.pieces[0];
  EXPECT_TRUE(find_edge(gore, "hem")->points[0].at.isApprox(Eigen::Vector2d(0, 0)));
  EXPECT_TRUE(find_edge(gore, "right")->points[0].at.isApprox(Eigen::Vector2d(.2, 0)));
  EXPECT_TRUE(find_edge(gore, "top")->points[0].at.isApprox(Eigen::Vector2d(.15, .5)));
  EXPECT_TRUE(find_edge(gore, "left")->points[1].at.isApprox(Eigen::Vector2d(0, 0)));
}

TEST(NameEdges, CountsFromCoordinatesOrFromWhereTheOutlineBegins) {
  const auto by_place = applied(one_piece("start = [\"201 mm\", \"0 mm\"]\nedges = [\"a\", \"b\", \"c\", \"d\"]\n"));
  EXPECT_TRUE(find_edge(by_place.pieces[0], "a")->points[0].at.isApprox(Eigen::Vector2d(.2, 0)));
  const auto by_default = applied(one_piece("edges = [\"a\", \"b\", \"c\", \"d\"]\n"));
  EXPECT_TRUE(find_edge(by_default.pieces[0], "a")->points[0].at.isApprox(Eigen::Vector2d(.15, .5)));
}

TEST(NameEdges, AnEmptyNameKeepsTheNumber) {
  const auto pattern = applied(one_piece("edges = [\"top\", \"\", \"hem\", \"\"]\n"));
  EXPECT_EQ(pattern.pieces[0].outline[1].id, "e1");
}

TEST(NameEdges, NotchesMoveWithTheirEdge) {
  const Pattern pattern = applied(pieces);
  EXPECT_EQ(pattern.pieces[0].notches[0].edge, "left");
  EXPECT_EQ(pattern.pieces[0].notches[0].at, .25);
}

TEST(NameEdges, NeighboursOfOneNameBecomeOneEdgeAlsoOverTheStartCorner) {
  // A rectangle 40 x 10 cm whose bottom is broken at a quarter and at a half.
  Pattern pattern;
  pattern.pieces = {polygon("P", {{.1, 0}, {.2, 0}, {.4, 0}, {.4, .1}, {0, .1}, {0, 0}})};
  pattern.pieces[0].notches = {{"e1", .5, NotchKind::v, 4e-3, 0}, {"e5", .5, NotchKind::v, 4e-3, 0}};
  const auto joined =
      applied("[[piece]]\nname = \"P\"\nedges = [\"bottom\", \"bottom\", \"right\", \"top\", \"left\", \"bottom\"]\n", pattern);
  const Piece& piece = joined.pieces[0];
  ASSERT_EQ(piece.outline.size(), 4u);
  const Edge& bottom = *find_edge(piece, "bottom");
  EXPECT_NEAR(length(bottom), .4, 1e-12);
  EXPECT_TRUE(bottom.points.front().at.isApprox(Eigen::Vector2d(0, 0)));
  ASSERT_EQ(bottom.points.size(), 4u);
  EXPECT_FALSE(bottom.points[1].turn);
  EXPECT_EQ(piece.notches[0].edge, "bottom");
  EXPECT_NEAR(piece.notches[0].at, .75, 1e-12);
  EXPECT_NEAR(piece.notches[1].at, .125, 1e-12);
  EXPECT_NEAR(signed_area(piece), .04, 1e-12);
}

TEST(NameEdges, JoiningOverACornerIsAWarning) {
  EXPECT_EQ(first_finding(one_piece("edges = [\"a\", \"a\", \"b\", \"c\"]\n")).code, "seam.joined-corner");
}

TEST(NameEdges, AWrongCountListsTheEdgesThereAre) {
  const Finding f = first_finding(one_piece("start = \"bottom left\"\nedges = [\"hem\", \"right\", \"top\"]\n"));
  EXPECT_EQ(f.code, "seam.edge-count");
  EXPECT_EQ(f.place, "skirt.seams.toml:4");
  EXPECT_NE(f.remedy.find("1: (0.0 mm, 0.0 mm) to (200.0 mm, 0.0 mm), 200.0 mm long"), std::string::npos) << f.remedy;
}

TEST(NameEdges, ComplainsOfNamesAndCornersThatCannotBe) {
  EXPECT_EQ(first_finding(one_piece("edges = [\"a\", \"b\", \"a\", \"c\"]\n")).code, "seam.edge-name");
  EXPECT_EQ(first_finding(one_piece("edges = [\"a.b\", \"b\", \"c\", \"d\"]\n")).code, "seam.edge-name");
  EXPECT_EQ(first_finding(one_piece("start = \"middle\"\nedges = [\"a\", \"b\", \"c\", \"d\"]\n")).code, "seam.start");
  EXPECT_EQ(first_finding(one_piece("start = [\"9 cm\", \"9 cm\"]\nedges = [\"a\", \"b\", \"c\", \"d\"]\n")).code,
            "seam.start");
  EXPECT_EQ(first_finding(one_piece("start = \"bottom left\"\n")).code, "seam.start");
}

}  // namespace
}  // namespace toile
