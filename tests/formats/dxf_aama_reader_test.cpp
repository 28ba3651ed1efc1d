// The dialects of real files, each in a small file that has nothing else.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <numbers>

#include "formats/aama_pieces.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/layers.h"
#include "formats/dxf_aama/texts.h"
#include "formats/dxf_aama/turn_points.h"
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

TEST(AamaReader, ReadsNotchesOfEveryWriter) {
  const std::string notches = point_on("4", {0, 300}, tag(30, "-3.998") + tag(39, "2.9998")) +  // AccuMark: negative depth
                              point_on("4", {420, 300}) +                                       // CLO: neither depth nor width
                              point_on("81", {200, 0}, tag(30, "5") + tag(39, "2") + tag(50, "90")) +
                              line_on("4", {100, 0}, {100, 6}) + line_on("4", {300, 6}, {300, 0});  // Valentina 0.7: lines
  const Piece piece = piece_of(pattern_file(block("A", cut + sew + notches)));
  ASSERT_EQ(piece.notches.size(), 5u);
  const auto at = [&](std::size_t i) { return on_edge(*find_edge(piece, piece.notches[i].edge), piece.notches[i].at); };
  EXPECT_EQ(piece.notches[0].kind, NotchKind::v);
  EXPECT_NEAR(piece.notches[0].depth, 3.998e-3, 1e-9);
  EXPECT_NEAR((at(0) - Eigen::Vector2d(.01, .3)).norm(), 0, 1e-9);
  EXPECT_EQ(piece.notches[1].kind, NotchKind::slit);
  EXPECT_NEAR(piece.notches[1].depth, 4e-3, 1e-9);
  EXPECT_EQ(piece.notches[2].kind, NotchKind::castle);
  EXPECT_NEAR((at(3) - Eigen::Vector2d(.1, .01)).norm(), 0, 1e-9);
  EXPECT_NEAR((at(4) - Eigen::Vector2d(.3, .01)).norm(), 0, 1e-9);
  EXPECT_NEAR(piece.notches[4].depth, 6e-3, 1e-9);
}

TEST(AamaReader, CountsANotchOnBothLinesOnceAndReportsStrayOnes) {
  const std::string notches = point_on("4", {0, 300}) + point_on("4", {10, 300.4}) + point_on("4", {0, 300}) +
                              point_on("4", {0, 320}) + point_on("4", {410, 120}) + line_on("8", {100, 100}, {200, 100}) +
                              point_on("4", {150, 100}) + point_on("4", {16, 400}) + point_on("4", {200, 300});
  const Loaded<Pattern> loaded = read(pattern_file(block("A", cut + sew + notches)));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pieces[0].notches.size(), 4u);
  EXPECT_EQ(count(loaded.report, "aama.notch-on-internal-line"), 1);
  EXPECT_EQ(count(loaded.report, "aama.notch-off-outline"), 2);
}

TEST(AamaReader, PutsANotchOnACornerAtTheStartOfAnEdge) {
  const Piece piece =
      piece_of(pattern_file(block("A", polyline_on("1", rectangle(0, 0, 400, 600), true) + point_on("4", {400, 0}))));
  ASSERT_EQ(piece.notches.size(), 1u);
  EXPECT_EQ(piece.notches[0].edge, "e1");
  EXPECT_EQ(piece.notches[0].at, 0);
}

TEST(AamaReader, KeepsLinesOfUnknownLayersAndSaysSo) {
  const std::string odd = line_on("100", {50, 50}, {60, 60}) + line_on("DRAFT", {50, 50}, {60, 60}) +
                          line_on("5", {50, 50}, {60, 60}) + tag(0, "SPLINE") + tag(8, "8") + tag(70, "8");
  const Loaded<Pattern> loaded = read(pattern_file(block("A", cut + odd)));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pieces[0].internal_lines.size(), 2u);
  EXPECT_EQ(count(loaded.report, "aama.unknown-layer"), 2);
  EXPECT_EQ(count(loaded.report, "aama.unsupported-entity"), 1);
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

TEST(AamaReader, TakesPiecesNotLayoutBlocks) {
  const Loaded<Pattern> loaded =
      read(pattern_file(block("$MODEL_SPACE", "") + block("*Paper_Space", text_on("1", "x")) + block("FRONT", cut)));
  ASSERT_TRUE(loaded.value);
  ASSERT_EQ(loaded.value->pieces.size(), 1u);
  EXPECT_EQ(loaded.value->pieces[0].name, "FRONT");
}

TEST(AamaReader, ReadsTheSampleSizeOfANest) {
  std::string blocks;
  for (const int size : {36, 38, 40})
    blocks += block("F_" + std::to_string(size), name + text_on("1", "SIZE: " + std::to_string(size)) +
                                                     polyline_on("1", rectangle(0, 0, 10 * size, 600), true));
  const Loaded<Pattern> loaded = read(pattern_file(blocks, {"Units: METRIC", "Sample Size: 38"}));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  ASSERT_EQ(loaded.value->pieces.size(), 1u);
  EXPECT_NEAR(signed_area(loaded.value->pieces[0]), .38 * .6, 1e-9);
  EXPECT_NE(find(loaded.report, "aama.sizes-ignored")->text.find("36, 40"), std::string::npos);
}

TEST(AamaReader, TakesTheMarkedUpSizeWhenTheSampleSizeIsNotNamed) {
  const std::string blocks = block("F_36", name + text_on("1", "Size: 36") + cut) +
                             block("F_38", name + text_on("1", "Size: 38") + cut + point_on("2", {0, 0}));
  const Loaded<Pattern> loaded = read(pattern_file(blocks, {"Units: METRIC", "Sample Size: NONE"}));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_EQ(loaded.value->sample_size, "38");
  EXPECT_TRUE(find(loaded.report, "aama.sample-size"));
}

TEST(AamaReader, NumbersUnnamedPiecesWhoseBlocksHaveOneName) {
  const Loaded<Pattern> loaded = read(pattern_file(block("DETAIL", cut) + block("DETAIL", cut)));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_EQ(loaded.value->pieces[1].name, "DETAIL-2");
  EXPECT_TRUE(find(loaded.report, "aama.piece-renamed"));
}

TEST(AamaReader, ReadsPieceTexts) {
  const std::string texts = text_on("1", "PIECE NAME:left front") + text_on("1", "quantity : 1,0") +
                            text_on("1", "Fabric: lining") + text_on("1", "ANNOTATION: cut on bias") +
                            text_on("1", "ANNOTATION:") + text_on("1", "CATEGORY: FRONT") + text_on("1", "# 4");
  const Piece piece = piece_of(pattern_file(block("A", texts + cut)));
  EXPECT_EQ(piece.name, "left front");
  EXPECT_EQ(piece.quantity, 1);
  EXPECT_EQ(piece.mirrored_quantity, 0);
  EXPECT_EQ(piece.material, "lining");
  EXPECT_EQ(piece.annotations, (std::vector<std::string>{"cut on bias", "CATEGORY: FRONT"}));
}

TEST(AamaReader, ReadsQuantitiesAsRightAndLeft) {
  const auto quantity = [&](const std::string& text) {
    const Piece piece = piece_of(pattern_file(block("A", text_on("1", "Quantity: " + text) + cut)));
    return std::pair{piece.quantity, piece.mirrored_quantity};
  };
  EXPECT_EQ(quantity("2"), (std::pair{2, 0}));
  EXPECT_EQ(quantity("1,1"), (std::pair{1, 1}));
  EXPECT_EQ(quantity("0,1"), (std::pair{0, 1}));
  EXPECT_EQ(quantity("0"), (std::pair{1, 0}));
  EXPECT_EQ(quantity("0,0"), (std::pair{1, 0}));
  EXPECT_EQ(quantity("two"), (std::pair{1, 0}));
  EXPECT_EQ(quantity("-1"), (std::pair{1, 0}));
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

TEST(AamaReader, RefusesWhatIsNoPattern) {
  EXPECT_EQ(error_of(pattern_file("")).code, "aama.no-piece");
  EXPECT_EQ(error_of(section("ENTITIES", polyline_on("0", rectangle(0, 0, 9, 9), true)) + tag(0, "EOF")).code, "aama.no-piece");
  EXPECT_EQ(error_of(pattern_file(block("A", name + cut) + block("B", name + cut))).code, "aama.duplicate-piece");
  EXPECT_EQ(error_of(pattern_file(block("A", polyline_on("1", {{0, 0}, {300, 0}, {300, 0}}, true)))).code, "aama.open-outline");
  const std::string file = pattern_file(block("A", cut));
  EXPECT_EQ(error_of(file.substr(0, file.size() / 2)).code, "dxf.truncated");
}

TEST(AamaLayers, AreATableWithoutRepetitions) {
  for (const aama::Layer& a : aama::layers) {
    EXPECT_EQ(aama::find_layer(a.number), &a);
    EXPECT_TRUE(a.read || !a.written) << a.number;
  }
  EXPECT_EQ(aama::role_of("12"), aama::Role::unknown);
  EXPECT_EQ(aama::number_of(aama::Role::sew_line), "14");
  EXPECT_EQ(aama::notch_layer(NotchKind::v), "4");
  EXPECT_EQ(aama::notch_layer(NotchKind::u), "83");
}

TEST(AamaLayers, AreTheRowsOfTheReadme) {
  std::ifstream in(std::string(TOILE_SOURCE_DIR) + "/formats/dxf_aama/README.md");
  std::vector<std::string> rows, table;
  for (std::string line; std::getline(in, line);)
    if (line.size() > 3 && line[0] == '|' && line[2] >= '0' && line[2] <= '9') rows.push_back(line);
  const char* shapes[] = {"closed", "lines", "segment", "points", "text"};
  for (const aama::Layer& layer : aama::layers)
    table.push_back("| " + std::string(layer.number) + " | " + std::string(layer.name) + " | " +
                    shapes[static_cast<std::size_t>(layer.shape)] + " | " + (layer.read ? "yes" : "no") + " | " +
                    (layer.written ? "yes" : "no") + " |");
  EXPECT_EQ(rows, table);
}

std::vector<std::size_t> corners(const Xy& ring) {
  const std::vector<bool> flags = aama::corners_by_angle(ring, 20 * std::numbers::pi / 180);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < flags.size(); ++i)
    if (flags[i]) found.push_back(i);
  return found;
}

TEST(CornersByAngle, AreNotTheVerticesOfASampledCurve) {
  for (const int n : {12, 16, 24, 60, 400}) {
    Xy circle;
    for (int i = 0; i < n; ++i)
      circle.emplace_back(std::cos(2 * i * std::numbers::pi / n), std::sin(2 * i * std::numbers::pi / n));
    EXPECT_TRUE(corners(circle).empty()) << n;
  }
  EXPECT_EQ(corners(rectangle(0, 0, 1, 2)).size(), 4u);
}

TEST(CornersByAngle, AreFoundWhereACurveMeetsALineHoweverDenselyItIsDrawn) {
  for (const int n : {6, 20, 200}) {  // a half disc: two corners of 90 degrees
    Xy half;
    for (int i = 0; i <= n; ++i) half.emplace_back(std::cos(i * std::numbers::pi / n), std::sin(i * std::numbers::pi / n));
    EXPECT_EQ(corners(half), (std::vector<std::size_t>{0, static_cast<std::size_t>(n)})) << n;
  }
}

TEST(CornersByAngle, CountACornerDrawnWithTwoNearVerticesOnce) {
  EXPECT_EQ(corners({{0, 0}, {1, 0}, {1, 1}, {.0001, 1}, {0, .9999}}).size(), 4u);
}

}  // namespace
}  // namespace toile
