// Outlines as programs draw them, each in a small file that has nothing else.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"

namespace toile {
namespace {

Loaded<Pattern> read(const std::string& bytes) { return read_dxf_aama_bytes(bytes, "front.dxf"); }

// The only piece; fails the test when the file is refused.
Piece piece_of(const std::string& bytes) {
  const Loaded<Pattern> loaded = read(bytes);
  EXPECT_TRUE(loaded.value) << all_words(loaded.report);
  if (!loaded.value || loaded.value->pieces.size() != 1) return {};
  EXPECT_GT(signed_area(loaded.value->pieces[0]), 0);
  return loaded.value->pieces[0];
}

Finding error_of(const std::string& bytes) {
  const Loaded<Pattern> loaded = read(bytes);
  EXPECT_FALSE(loaded.value);
  for (const Finding& finding : loaded.report.findings)
    if (finding.severity == Severity::error) return finding;
  ADD_FAILURE() << "no error";
  return {};
}

const std::string cut = polyline_on("1", rectangle(0, 0, 420, 620), true);
const std::string sew = polyline_on("14", rectangle(10, 10, 410, 590), true);
const std::string name = text_on("1", "Piece Name: front");
const std::string grain = line_on("7", {200, 100}, {200, 500});

TEST(AamaReader, TakesTheSewLineAsOutlineAndMeasuresTheAllowances) {
  const Piece piece = piece_of(pattern_file(block("A", name + cut + sew + grain)));
  ASSERT_EQ(piece.outline.size(), 4u);
  EXPECT_EQ(piece.outline[0].id, "e0");
  EXPECT_EQ(piece.outline[0].points[0].at, Eigen::Vector2d(.01, .01));
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(*piece.outline[static_cast<std::size_t>(i)].seam_allowance, i == 2 ? .03 : .01, 1e-6);
}

TEST(AamaReader, TakesTheBoundaryAsNetWhenThereIsNoOtherLineAndSaysSo) {
  const Loaded<Pattern> loaded = read(pattern_file(block("A", name + cut)));
  ASSERT_TRUE(loaded.value);
  EXPECT_FALSE(loaded.value->pieces[0].outline[0].seam_allowance);
  ASSERT_TRUE(find(loaded.report, "aama.no-sew-line"));
  EXPECT_EQ(find(loaded.report, "aama.no-sew-line")->severity, Severity::warning);
  EXPECT_EQ(find(loaded.report, "aama.no-sew-line")->place, "front.dxf:5, piece 'front'");
  EXPECT_TRUE(find(loaded.report, "aama.no-grain-line"));
}

TEST(AamaReader, FindsTheSewLineOnLayer8ButNotAFacingLine) {
  const Piece valentina = piece_of(pattern_file(block("A", cut + polyline_on("8", rectangle(10, 10, 410, 590), true))));
  EXPECT_NEAR(signed_area(valentina), .4 * .58, 1e-9);
  EXPECT_TRUE(valentina.internal_lines.empty());
  const Piece pocket = piece_of(pattern_file(block("A", cut + polyline_on("8", rectangle(100, 100, 200, 220), true))));
  EXPECT_NEAR(signed_area(pocket), .42 * .62, 1e-9);
  EXPECT_EQ(pocket.internal_lines.size(), 1u);
}

TEST(AamaReader, JoinsRunsGivenInAnyOrderAndDirection) {
  const std::vector<Xy> sides{
      {{0, 0}, {200, -5}, {400, 0}}, {{400, 0}, {400, 600}}, {{400, 600}, {0, 600}}, {{0, 600}, {0, 0}}};
  std::vector<int> order{0, 1, 2, 3};
  do
    for (int reversed = 0; reversed < 16; ++reversed) {
      std::string runs;
      for (const int i : order) {
        Xy run = sides[static_cast<std::size_t>(i)];
        if (reversed & (1 << i)) std::reverse(run.begin(), run.end());
        runs += polyline_on("1", run, false);
      }
      const Piece piece = piece_of(pattern_file(block("A", runs)));
      ASSERT_EQ(piece.outline.size(), 4u);
      ASSERT_NEAR(signed_area(piece), .4 * .6 + .4 * .005 / 2, 1e-9);
    }
  while (std::next_permutation(order.begin(), order.end()));
}

TEST(AamaReader, ClosesByFlagOrByARepeatedVertexAndDropsDuplicates) {
  const Xy ring = rectangle(0, 0, 400, 600);
  Xy repeated = ring, doubled = ring;
  repeated.push_back(ring[0]);
  doubled.insert(doubled.begin() + 2, ring[1]);
  Xy both = repeated;
  for (const std::string& lines :
       {polyline_on("1", ring, true), polyline_on("1", repeated, false), polyline_on("1", both, true),
        polyline_on("1", doubled, true), polyline_on("1", ring, true) + polyline_on("1", {{5, 5}}, false)}) {
    const Piece piece = piece_of(pattern_file(block("A", lines)));
    ASSERT_EQ(piece.outline.size(), 4u);
    for (const Edge& edge : piece.outline) EXPECT_EQ(edge.points.size(), 2u);
  }
}

TEST(AamaReader, RunsCounterClockwiseFromTheFirstTurnPointInTheFile) {
  const Xy clockwise{{0, 300}, {0, 600}, {400, 600}, {400, 0}, {0, 0}};  // begins with a curve point
  std::string marks = point_on("3", {0, 300});
  for (const Eigen::Vector2d& at : rectangle(0, 0, 400, 600)) marks += point_on("2", at);
  const Piece piece = piece_of(pattern_file(block("A", polyline_on("1", clockwise, true) + marks)));
  ASSERT_EQ(piece.outline.size(), 4u);
  EXPECT_EQ(piece.outline[0].points.front().at, Eigen::Vector2d(0, .6));
  EXPECT_EQ(piece.outline[0].points.size(), 3u);  // down the left side, over the curve point
  EXPECT_FALSE(piece.outline[0].points[1].turn);
  EXPECT_EQ(piece.outline[1].points.front().at, Eigen::Vector2d(0, 0));
}

TEST(AamaReader, MatchesTurnPointsWithinTheirPrecision) {
  std::string marks;
  for (const Eigen::Vector2d& at : rectangle(0, 0, 400, 600)) marks += point_on("2", at + Eigen::Vector2d(.008, -.008));
  marks += point_on("2", {200, 0}) + point_on("2", {200, 300});
  const Loaded<Pattern> loaded =
      read(pattern_file(block("A", polyline_on("1", {{0, 0}, {200, 0}, {400, 0}, {400, 600}, {0, 600}}, true) + marks)));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pieces[0].outline.size(), 5u);  // a collinear turn point is one: two seams meet there
  EXPECT_FALSE(find(loaded.report, "aama.turn-points-by-angle"));
}

TEST(AamaReader, JoinsCornersDrawnTwiceAHairApart) {
  std::string marks;
  Xy ring = rectangle(0, 0, 400, 600);
  ring.push_back({.04, .05});  // of the first corner
  for (const Eigen::Vector2d& at : ring) marks += point_on("2", at);
  EXPECT_EQ(piece_of(pattern_file(block("A", polyline_on("1", ring, true) + marks))).outline.size(), 4u);
}

TEST(AamaReader, UnfoldsAHalfAndAllThatIsOnIt) {
  // The right half of a piece whose fold is the y axis, boundary clockwise as drawn, sew line as open runs up to the fold.
  const std::string half = polyline_on("1", {{0, 0}, {0, 630}}, false) + polyline_on("1", {{0, 630}, {110, 630}}, false) +
                           polyline_on("1", {{110, 630}, {210, 0}}, false) + polyline_on("1", {{210, 0}, {0, 0}}, false) +
                           polyline_on("14", {{0, 620}, {100, 620}}, false) +
                           polyline_on("14", {{100, 620}, {198, 10}}, false) + polyline_on("14", {{198, 10}, {0, 10}}, false) +
                           line_on("6", {0, 0}, {0, 630}) + point_on("2", {0, 620}) + point_on("2", {100, 620}) +
                           point_on("2", {198, 10}) + point_on("2", {0, 10}) + point_on("4", {50, 630}, tag(30, "3")) +
                           point_on("4", {0, 630}, tag(30, "3")) + point_on("13", {40, 100}) +
                           line_on("8", {20, 200}, {60, 200}) + line_on("8", {20, 300}, {60, 300}) +
                           text_on("8", "NM", {20, 300}) + point_on("4", {20, 300}) + line_on("7", {60, 100}, {60, 500});
  const Loaded<Pattern> loaded = read(pattern_file(block("A", name + half)));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_TRUE(find(loaded.report, "aama.unfolded"));
  const Piece& piece = loaded.value->pieces[0];
  EXPECT_NEAR(signed_area(piece), (.1 + .198) * .61, 1e-6);
  ASSERT_EQ(piece.outline.size(), 4u);  // top and hem run across the fold
  for (const Edge& edge : piece.outline) {
    EXPECT_EQ(edge.points.size(), 2u) << edge.id;
    EXPECT_GT(edge.seam_allowance.value_or(0), 9e-3);
  }
  EXPECT_EQ(piece.notches.size(), 3u);
  EXPECT_EQ(piece.drill_holes.size(), 2u);
  EXPECT_EQ(piece.internal_lines.size(), 3u);
  EXPECT_EQ(piece.grainline->from, Eigen::Vector2d(.06, .1));
}

TEST(AamaReader, KeepsACornerOnTheFold) {
  const std::string half = polyline_on("1", {{0, 0}, {200, 0}, {200, 600}, {0, 500}}, true) + line_on("6", {0, 0}, {0, 500});
  const Piece piece = piece_of(pattern_file(block("A", half)));
  ASSERT_EQ(piece.outline.size(), 5u);
  EXPECT_NEAR(signed_area(piece), 2 * .2 * .55, 1e-9);
}

TEST(AamaReader, ClosesASewLineAlongTheCutLineWhereThereIsNoAllowance) {
  // Cut on the line at the top: the sew line is drawn for the other three sides only.
  const std::string runs = polyline_on("14", {{10, 620}, {10, 10}}, false) + polyline_on("14", {{10, 10}, {410, 10}}, false) +
                           polyline_on("14", {{410, 10}, {410, 620}}, false);
  const Piece piece = piece_of(pattern_file(block("A", cut + runs)));
  ASSERT_EQ(piece.outline.size(), 4u);
  EXPECT_NEAR(signed_area(piece), .4 * .61, 1e-9);
  for (const Edge& edge : piece.outline)
    EXPECT_NEAR(edge.seam_allowance.value_or(9), edge.points[0].at.y() > .6 && edge.points[1].at.y() > .6 ? 0 : .01, 1e-6)
        << edge.id;
}

TEST(AamaReader, TakesTheDenserCopyOfALine) {
  const double pi = std::numbers::pi;
  Xy coarse, dense;
  for (int i = 0; i < 64; ++i) {
    const Eigen::Vector2d at(200 * std::cos(i * pi / 32), 200 * std::sin(i * pi / 32));
    dense.push_back(at);
    if (i % 4 == 0) coarse.push_back(at);
  }
  EXPECT_NEAR(signed_area(piece_of(pattern_file(block("A", polyline_on("1", coarse, true))))), 16 * .02 * std::sin(pi / 8),
              1e-6);
  EXPECT_NEAR(signed_area(piece_of(pattern_file(block("A", polyline_on("1", coarse, true) + polyline_on("84", dense, true))))),
              64 * .02 * std::sin(pi / 32), 1e-6);
}

TEST(AamaReader, HonoursWhereABlockIsInserted) {
  const std::string file =
      section("BLOCKS", block("A", name + polyline_on("1", rectangle(0, 0, 100, 300), true) + grain)) +
      section("ENTITIES", text_on("1", "units: metric") + tag(0, "INSERT") + tag(8, "1") + tag(2, "A") + tag(10, "1000") +
                              tag(20, "0") + tag(41, "2") + tag(42, "2") + tag(50, "90")) +
      tag(0, "EOF");
  const Piece piece = piece_of(file);
  EXPECT_NEAR(signed_area(piece), .2 * .6, 1e-9);
  EXPECT_LT((piece.outline[0].points[0].at - Eigen::Vector2d(1, 0)).norm(), 1e-9);
  EXPECT_LT((piece.outline[0].points[1].at - Eigen::Vector2d(1, .2)).norm(), 1e-9);
}

TEST(AamaReader, SaysWhereAnOutlineIsOpenInMillimetres) {
  const Finding error =
      error_of(pattern_file(block("A", name + polyline_on("1", {{0, 0}, {400, 0}, {400, 600}, {0, 600}, {0, .75}}, false))));
  EXPECT_EQ(error.code, "aama.open-outline");
  EXPECT_EQ(error.fault, Fault::bad_input);
  EXPECT_NE(error.place.find("front.dxf:"), std::string::npos);
  EXPECT_NE(error.place.find("piece 'front'"), std::string::npos);
  EXPECT_NE(error.text.find("0.75 mm from (0.00, 0.75) mm to (0.00, 0.00) mm"), std::string::npos) << error.text;
  EXPECT_FALSE(error.remedy.empty());
  // Nearer ends are meant to join.
  EXPECT_EQ(piece_of(pattern_file(block("A", polyline_on("1", {{0, 0}, {400, 0}, {400, 600}, {0, 600}, {0, .4}}, false))))
                .outline.size(),
            4u);
}

TEST(AamaReader, WarnsOfAnOutlineThatCrossesItself) {
  const auto crossings = [](const Xy& ring) {
    const Loaded<Pattern> loaded = read(pattern_file(block("A", polyline_on("1", ring, true))));
    EXPECT_TRUE(loaded.value);
    return count(loaded.report, "aama.crossing-outline");
  };
  EXPECT_EQ(crossings({{0, 0}, {400, 0}, {400, 600}, {200, -50}, {0, 600}}), 1);
  EXPECT_EQ(crossings({{0, 0}, {400, 0}, {400, 600}, {200, 0}, {0, 600}}), 0);  // touches
  EXPECT_EQ(crossings(rectangle(0, 0, 400, 600)), 0);
}

TEST(AamaReader, NumbersPiecesOfOneName) {
  const Loaded<Pattern> loaded = read(pattern_file(block("A", name + cut) + block("B", name + cut)));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  ASSERT_EQ(loaded.value->pieces.size(), 2u);
  EXPECT_EQ(loaded.value->pieces[0].name, "front");
  EXPECT_EQ(loaded.value->pieces[1].name, "front-2");
  EXPECT_EQ(count(loaded.report, "aama.piece-renamed"), 1);
}

TEST(AamaReader, RefusesWhatIsNoPattern) {
  EXPECT_EQ(error_of(pattern_file("")).code, "aama.no-piece");
  EXPECT_EQ(error_of(section("ENTITIES", line_on("0", {0, 0}, {9, 9})) + tag(0, "EOF")).code, "aama.no-piece");
  EXPECT_EQ(error_of(pattern_file(block("A", polyline_on("1", {{0, 0}, {300, 0}, {300, 0}}, true)))).code, "aama.open-outline");
  const std::string file = pattern_file(block("A", cut));
  EXPECT_EQ(error_of(file.substr(0, file.size() / 2)).code, "dxf.truncated");
}

}  // namespace
}  // namespace toile
