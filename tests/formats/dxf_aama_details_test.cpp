// Notches, texts, sizes and layers as programs write them.

#include <gtest/gtest.h>

#include <fstream>

#include "formats/aama_pieces.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_aama/layers.h"
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

const std::string cut = polyline_on("1", rectangle(0, 0, 420, 620), true);
const std::string sew = polyline_on("14", rectangle(10, 10, 410, 590), true);
const std::string name = text_on("1", "Piece Name: front");

TEST(AamaDetails, ReadsNotchesOfEveryWriter) {
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

TEST(AamaDetails, CountsANotchOnBothLinesOnceAndReportsStrayOnes) {
  const std::string notches = point_on("4", {0, 300}) + point_on("4", {10, 300.4}) + point_on("4", {0, 300}) +
                              point_on("4", {0, 320}) + point_on("4", {410, 120}) + line_on("8", {100, 100}, {200, 100}) +
                              point_on("4", {150, 100}) + point_on("4", {16, 400}) + point_on("4", {200, 300});
  const Loaded<Pattern> loaded = read(pattern_file(block("A", cut + sew + notches)));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pieces[0].notches.size(), 4u);
  EXPECT_EQ(count(loaded.report, "aama.notch-on-internal-line"), 1);
  EXPECT_EQ(count(loaded.report, "aama.notch-off-outline"), 2);
}

TEST(AamaDetails, PutsANotchOnACornerAtTheStartOfAnEdge) {
  const Piece piece =
      piece_of(pattern_file(block("A", polyline_on("1", rectangle(0, 0, 400, 600), true) + point_on("4", {400, 0}))));
  ASSERT_EQ(piece.notches.size(), 1u);
  EXPECT_EQ(piece.notches[0].edge, "e1");
  EXPECT_EQ(piece.notches[0].at, 0);
}

TEST(AamaDetails, KeepsLinesOfUnknownLayersAndSaysSo) {
  const std::string odd = line_on("100", {50, 50}, {60, 60}) + line_on("DRAFT", {50, 50}, {60, 60}) +
                          line_on("5", {50, 50}, {60, 60}) + tag(0, "SPLINE") + tag(8, "8") + tag(70, "8");
  const Loaded<Pattern> loaded = read(pattern_file(block("A", cut + odd)));
  ASSERT_TRUE(loaded.value);
  EXPECT_EQ(loaded.value->pieces[0].internal_lines.size(), 2u);
  EXPECT_EQ(count(loaded.report, "aama.unknown-layer"), 2);
  EXPECT_EQ(count(loaded.report, "aama.unsupported-entity"), 1);
}

TEST(AamaDetails, TakesPiecesNotLayoutBlocks) {
  const Loaded<Pattern> loaded =
      read(pattern_file(block("$MODEL_SPACE", "") + block("*Paper_Space", text_on("1", "x")) + block("FRONT", cut)));
  ASSERT_TRUE(loaded.value);
  ASSERT_EQ(loaded.value->pieces.size(), 1u);
  EXPECT_EQ(loaded.value->pieces[0].name, "FRONT");
}

TEST(AamaDetails, ReadsTheSampleSizeOfANest) {
  std::string blocks;
  for (const int size : {36, 38, 40})
    blocks += block("F_" + std::to_string(size), name + text_on("1", "SIZE: " + std::to_string(size)) +
                                                     polyline_on("1", rectangle(0, 0, 10 * size, 600), true));
  const Loaded<Pattern> loaded = read(pattern_file(blocks, {"Units: METRIC", "Sample Size: 38"}));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  ASSERT_EQ(loaded.value->pieces.size(), 1u);
  EXPECT_NEAR(signed_area(loaded.value->pieces[0]), .38 * .6, 1e-9);
  EXPECT_NE(find(loaded.report, "aama.nest")->text.find("36, 38, 40"), std::string::npos);
}

TEST(AamaDetails, TakesTheMarkedUpSizeWhenTheSampleSizeIsNotNamed) {
  const std::string blocks = block("F_36", name + text_on("1", "Size: 36") + cut) +
                             block("F_38", name + text_on("1", "Size: 38") + cut + point_on("2", {0, 0}));
  const Loaded<Pattern> loaded = read(pattern_file(blocks, {"Units: METRIC", "Sample Size: NONE"}));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_EQ(loaded.value->sample_size, "38");
  EXPECT_TRUE(find(loaded.report, "aama.sample-size"));
}

TEST(AamaDetails, NumbersUnnamedPiecesWhoseBlocksHaveOneName) {
  const Loaded<Pattern> loaded = read(pattern_file(block("DETAIL", cut) + block("DETAIL", cut)));
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  EXPECT_EQ(loaded.value->pieces[1].name, "DETAIL-2");
  EXPECT_TRUE(find(loaded.report, "aama.piece-renamed"));
}

TEST(AamaDetails, ReadsPieceTexts) {
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

TEST(AamaDetails, ReadsQuantitiesAsRightAndLeft) {
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

}  // namespace
}  // namespace toile
