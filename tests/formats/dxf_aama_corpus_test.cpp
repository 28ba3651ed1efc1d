// Real files of other programs. TOILE_CORPUS names the folder that has them under patterns/.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "formats/aama_pieces.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"
#include "formats/formats.h"

namespace toile {
namespace {

class AamaCorpus : public testing::Test {
 protected:
  void SetUp() override {
    const char* corpus = std::getenv("TOILE_CORPUS");
    if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
    patterns_ = std::filesystem::path(corpus) / "patterns";
    if (!std::filesystem::exists(patterns_)) GTEST_SKIP() << "no patterns in TOILE_CORPUS";
  }
  Loaded<Pattern> read(const std::string& file) const { return read_pattern(patterns_ / file); }
  Pattern pattern(const std::string& file) const {
    Loaded<Pattern> loaded = read(file);
    EXPECT_TRUE(loaded.value) << all_words(loaded.report);
    return loaded.value.value_or(Pattern{});
  }
  std::filesystem::path patterns_;
};

// Width and height of a piece in whole mm.
std::pair<int, int> size_mm(const Piece& piece) {
  Eigen::AlignedBox2d box;
  for (const Edge& edge : piece.outline)
    for (const OutlinePoint& point : edge.points) box.extend(point.at);
  return {static_cast<int>(std::lround(box.sizes().x() * 1e3)), static_cast<int>(std::lround(box.sizes().y() * 1e3))};
}

const Piece& piece(const Pattern& pattern, const std::string& name) {
  const Piece* found = find_piece(pattern, name);
  static const Piece none;
  EXPECT_TRUE(found) << name;
  return found ? *found : none;
}

bool all_allowances_are(const Piece& piece, double metres) {
  return std::all_of(piece.outline.begin(), piece.outline.end(),
                     [&](const Edge& edge) { return edge.seam_allowance && std::abs(*edge.seam_allowance - metres) < 5e-5; });
}

TEST_F(AamaCorpus, EveryDxfIsRead) {
  int files = 0, patterns = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(patterns_)) {
    std::string extension = entry.path().extension().string();
    if (extension != ".dxf" && extension != ".DXF") continue;
    ++files;
    const Loaded<Pattern> loaded = read_pattern(entry.path());
    EXPECT_EQ(loaded.value.has_value(), loaded.report.ok());
    const std::string name = entry.path().filename().string();
    const bool flat = name.find("_flat_") != std::string::npos || name.find("_R14_") != std::string::npos;
    EXPECT_EQ(count(loaded.report, "aama.flat-drawing"), flat) << name;
    ASSERT_TRUE(loaded.value) << name << "\n" << all_words(loaded.report);
    ++patterns;
    EXPECT_EQ(count(loaded.report, "aama.units"), 1) << name;
    for (const Piece& each : loaded.value->pieces) {
      EXPECT_GT(signed_area(each), 1e-3) << name << " " << each.name;
      EXPECT_LT(signed_area(each), 7) << name << " " << each.name;
      EXPECT_GE(each.outline.size(), 2u) << name << " " << each.name;
      for (const Edge& edge : each.outline) EXPECT_GT(length(edge), 1e-4) << name << " " << each.name;
    }
  }
  EXPECT_GE(files, 20);
  EXPECT_EQ(patterns, files);
}

TEST_F(AamaCorpus, CloBoxIsAClothOfThreeByTwoMetres) {
  const Pattern box = pattern("clo/clo-box.dxf");
  ASSERT_EQ(box.pieces.size(), 1u);
  EXPECT_EQ(box.sample_size, "M");
  EXPECT_EQ(box.pieces[0].name, "Pattern2D_4937");
  EXPECT_EQ(size_mm(box.pieces[0]), (std::pair{3002, 2002}));
  EXPECT_EQ(box.pieces[0].outline.size(), 4u);
  EXPECT_NEAR(box.pieces[0].grainline->to.y() - box.pieces[0].grainline->from.y(), .18, 1e-4);
}

TEST_F(AamaCorpus, CloInMillimetresAndInCentimetresIsOnePattern) {
  const Pattern mm = pattern("clo/clo-pattern.dxf"), cm = pattern("clo/clo2-pattern.dxf");
  ASSERT_EQ(mm.pieces.size(), 9u);
  ASSERT_EQ(cm.pieces.size(), 9u);
  EXPECT_EQ(size_mm(piece(mm, "7")), (std::pair{256, 729}));
  std::size_t notches = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(mm.pieces[i].name, cm.pieces[i].name);
    ASSERT_EQ(mm.pieces[i].outline.size(), cm.pieces[i].outline.size());
    EXPECT_EQ(mm.pieces[i].notches.size(), cm.pieces[i].notches.size());
    EXPECT_NEAR(signed_area(mm.pieces[i]), signed_area(cm.pieces[i]), 1e-6);
    for (std::size_t e = 0; e < mm.pieces[i].outline.size(); ++e)
      EXPECT_NEAR(length(mm.pieces[i].outline[e]), length(cm.pieces[i].outline[e]), 5e-5);
    notches += mm.pieces[i].notches.size();
  }
  EXPECT_EQ(notches, 18u);
  EXPECT_EQ(find(read("clo/clo-pattern.dxf").report, "aama.units")->severity, Severity::note);
  EXPECT_EQ(find(read("clo/clo2-pattern.dxf").report, "aama.units")->severity, Severity::warning);
}

TEST_F(AamaCorpus, AccumarkNestInInchesGivesItsSampleSize) {
  const Pattern simple = pattern("accumark/simple.DXF");
  EXPECT_EQ(simple.sample_size, "36");
  ASSERT_EQ(simple.pieces.size(), 4u);
  EXPECT_EQ(size_mm(piece(simple, "C-S1615WWO206-NB")), (std::pair{38, 720}));
  EXPECT_EQ(size_mm(piece(simple, "C-S1615WWO206-F")), (std::pair{648, 464}));
  EXPECT_EQ(piece(simple, "C-S1615WWO206-NB").outline.size(), 4u);
  EXPECT_EQ(piece(simple, "C-S1615WWO206-B").notches.size(), 3u);
  for (const Piece& each : simple.pieces) EXPECT_TRUE(each.grainline) << each.name;
}

TEST_F(AamaCorpus, AccumarkWithAllowanceHasItsSewLineUnfolded) {
  const Loaded<Pattern> loaded = read("accumark/GMH2446F17_INCLALLOWANCE_AAMA.DXF");
  ASSERT_TRUE(loaded.value);
  ASSERT_EQ(loaded.value->pieces.size(), 10u);
  EXPECT_EQ(count(loaded.report, "aama.no-sew-line"), 0);
  EXPECT_EQ(count(loaded.report, "aama.unfolded"), 2);
  const Piece& front = piece(*loaded.value, "GMH2446F17FA");
  EXPECT_EQ(size_mm(front), (std::pair{628, 572}));
  EXPECT_TRUE(all_allowances_are(front, .01));
  EXPECT_TRUE(all_allowances_are(piece(*loaded.value, "GMH2446F17SA"), .01));
  const Piece& hood = piece(*loaded.value, "GMH2446F17HO2");
  EXPECT_EQ(std::count_if(hood.outline.begin(), hood.outline.end(), [](const Edge& e) { return e.seam_allowance > .034; }), 1);
  EXPECT_EQ(hood.drill_holes.size(), 2u);
}

TEST_F(AamaCorpus, AccumarkAstmIsTheAamaFileWithDenserCurves) {
  const Pattern aama = pattern("accumark/GMH1006F18_AAMA.DXF"), astm = pattern("accumark/GMH1006F18_ASTM.DXF");
  ASSERT_EQ(aama.pieces.size(), 6u);
  ASSERT_EQ(astm.pieces.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(size_mm(aama.pieces[i]), size_mm(astm.pieces[i]));
    EXPECT_EQ(aama.pieces[i].outline.size(), astm.pieces[i].outline.size());
    EXPECT_EQ(aama.pieces[i].notches.size(), astm.pieces[i].notches.size());
    EXPECT_NEAR(signed_area(astm.pieces[i]) / signed_area(aama.pieces[i]), 1, .01);
  }
  EXPECT_EQ(piece(astm, "GMH1006FSL").mirrored_quantity, 1);
}

TEST_F(AamaCorpus, AccumarkHalvesAreWholePiecesOnBothSidesOfTheFold) {
  const Loaded<Pattern> loaded = read("accumark/mirrored.DXF");
  ASSERT_TRUE(loaded.value);
  ASSERT_EQ(loaded.value->pieces.size(), 17u);
  EXPECT_EQ(count(loaded.report, "aama.unfolded"), 13);
  EXPECT_EQ(size_mm(piece(*loaded.value, "GMG1016S19-BK")), (std::pair{786, 552}));
}

TEST_F(AamaCorpus, ValentinaHidesItsSewLineOnLayer8OfAama) {
  const Pattern r12 = pattern("valentina/maleshirt_AAMA_R12_1.dxf"), r2000 = pattern("valentina/maleshirt_AAMA_2000_1.dxf"),
                astm = pattern("valentina/maleshirt_ASTM_R12_1.dxf");
  for (const Pattern* each : {&r12, &r2000, &astm}) ASSERT_EQ(each->pieces.size(), 17u);
  EXPECT_EQ(size_mm(piece(r12, "FRONTPANEL")), (std::pair{373, 744}));
  EXPECT_EQ(size_mm(piece(r2000, "FrontPanel")), (std::pair{373, 744}));
  EXPECT_TRUE(all_allowances_are(piece(r12, "FRONTPANEL"), .01));
  EXPECT_TRUE(all_allowances_are(piece(r12, "SHORTSLEEVE"), .01));
  for (const Piece& each : astm.pieces) {  // sew line on layer 14 there: the same pieces
    const Piece& same = piece(r12, each.name);
    EXPECT_NEAR(signed_area(same), signed_area(each), 1e-7) << each.name;
    EXPECT_EQ(same.outline.size(), each.outline.size()) << each.name;
  }
}

// A sheet with the pieces cut net: what is written for real outlines is read again, point by point.
TEST_F(AamaCorpus, RealPiecesSurviveBeingWrittenAndRead) {
  for (const char* file : {"accumark/GMH2446F17_INCLALLOWANCE_AAMA.DXF", "accumark/mirrored.DXF", "accumark/drill-holes.DXF",
                           "accumark/simple.DXF", "clo/clo-pattern.dxf", "valentina/maleshirt_ASTM_R12_1.dxf",
                           "garmentcode/mh_f38/dress_fitted_pencil_sleeve.json"}) {
    const Pattern original = pattern(file);
    CutSheet sheet;
    for (const Piece& each : original.pieces) {
      CutPiece cut;
      cut.piece = each;
      for (const Edge& edge : each.outline) cut.cut_line.insert(cut.cut_line.end(), edge.points.begin(), edge.points.end() - 1);
      for (const Notch& notch : each.notches) {
        Eigen::Vector2d inwards = Eigen::Vector2d::UnitX();
        const Eigen::Vector2d at = on_edge(*find_edge(each, notch.edge), notch.at, &inwards);
        cut.notches.push_back({at, inwards, notch});
      }
      sheet.placed.push_back({cut, {0, 0}, 0});
    }
    const Loaded<Pattern> loaded = read_dxf_aama_bytes(dxf_aama_bytes(sheet), "again.dxf");
    ASSERT_TRUE(loaded.value) << file << "\n" << all_words(loaded.report);
    ASSERT_EQ(loaded.value->pieces.size(), original.pieces.size());
    for (std::size_t i = 0; i < original.pieces.size(); ++i) {
      const Piece &a = original.pieces[i], &b = loaded.value->pieces[i];
      const std::string which = std::string(file) + " " + a.name;
      EXPECT_EQ(a.name, b.name);
      EXPECT_EQ(a.notches.size(), b.notches.size()) << which;
      EXPECT_EQ(a.internal_lines.size(), b.internal_lines.size()) << which;
      EXPECT_EQ(a.drill_holes.size(), b.drill_holes.size()) << which;
      ASSERT_EQ(a.outline.size(), b.outline.size()) << which;
      for (std::size_t e = 0; e < a.outline.size(); ++e) {
        ASSERT_EQ(a.outline[e].points.size(), b.outline[e].points.size()) << which << " " << e;
        for (std::size_t k = 0; k < a.outline[e].points.size(); ++k)
          EXPECT_LT((a.outline[e].points[k].at - b.outline[e].points[k].at).norm(), 1e-7) << which;
        EXPECT_NEAR(b.outline[e].seam_allowance.value_or(0), 0, 1e-5) << which;
      }
    }
  }
}

}  // namespace
}  // namespace toile
