// What we write, we read: every field of every piece.

#include "formats/dxf_aama/dxf_aama.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "formats/aama_pieces.h"
#include "formats/dxf_aama/ascii.h"
#include "formats/dxf_text.h"
#include "formats/formats.h"

namespace toile {
namespace {

constexpr double written = 1e-7;  // m, half of the last digit written, and what is lost with it

Pattern reread(const CutSheet& sheet) {
  Loaded<Pattern> loaded = read_dxf_aama_bytes(dxf_aama_bytes(sheet), "sheet.dxf");
  EXPECT_TRUE(loaded.value) << all_words(loaded.report);
  for (const Finding& finding : loaded.report.findings) EXPECT_EQ(finding.severity, Severity::note) << in_words(finding);
  return loaded.value.value_or(Pattern{});
}

void expect_same_outline(const Piece& a, const Piece& b) {
  ASSERT_EQ(a.outline.size(), b.outline.size()) << a.name;
  for (std::size_t e = 0; e < a.outline.size(); ++e) {
    const Edge &x = a.outline[e], &y = b.outline[e];
    EXPECT_EQ(x.id, y.id);
    ASSERT_EQ(x.points.size(), y.points.size()) << a.name << " " << x.id;
    for (std::size_t i = 0; i < x.points.size(); ++i) {
      EXPECT_LT((x.points[i].at - y.points[i].at).norm(), written);
      EXPECT_EQ(x.points[i].turn, y.points[i].turn);
      EXPECT_EQ(x.points[i].grade_rule, y.points[i].grade_rule);
    }
    ASSERT_TRUE(y.seam_allowance) << a.name << " " << x.id;
    EXPECT_NEAR(*x.seam_allowance, *y.seam_allowance, 2e-5) << a.name << " " << x.id;
  }
}

void expect_same(const Piece& a, const Piece& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.quantity, b.quantity);
  EXPECT_EQ(a.mirrored_quantity, b.mirrored_quantity);
  EXPECT_EQ(a.material, b.material);
  EXPECT_EQ(a.annotations, b.annotations);
  expect_same_outline(a, b);
  ASSERT_EQ(a.notches.size(), b.notches.size());
  for (std::size_t i = 0; i < a.notches.size(); ++i) {
    EXPECT_EQ(a.notches[i].edge, b.notches[i].edge) << i;
    EXPECT_EQ(a.notches[i].kind, b.notches[i].kind) << i;
    EXPECT_NEAR(a.notches[i].at, b.notches[i].at, 1e-6) << i;
    EXPECT_NEAR(a.notches[i].depth, b.notches[i].depth, written);
    EXPECT_NEAR(a.notches[i].width, b.notches[i].width, written);
  }
  ASSERT_EQ(a.drill_holes.size(), b.drill_holes.size());
  for (std::size_t i = 0; i < a.drill_holes.size(); ++i) {
    EXPECT_LT((a.drill_holes[i].at - b.drill_holes[i].at).norm(), written);
    EXPECT_NEAR(a.drill_holes[i].diameter, b.drill_holes[i].diameter, written);
  }
  ASSERT_EQ(a.internal_lines.size(), b.internal_lines.size());
  for (std::size_t i = 0; i < a.internal_lines.size(); ++i) {
    EXPECT_EQ(a.internal_lines[i].cut_out, b.internal_lines[i].cut_out);
    ASSERT_EQ(a.internal_lines[i].points.size(), b.internal_lines[i].points.size());
    for (std::size_t k = 0; k < a.internal_lines[i].points.size(); ++k)
      EXPECT_LT((a.internal_lines[i].points[k] - b.internal_lines[i].points[k]).norm(), written);
  }
  ASSERT_EQ(a.grainline.has_value(), b.grainline.has_value());
  if (a.grainline) {
    EXPECT_LT((a.grainline->from - b.grainline->from).norm(), written);
    EXPECT_LT((a.grainline->to - b.grainline->to).norm(), written);
  }
}

TEST(DxfAamaRoundTrip, KeepsEveryPieceWithAllItCarries) {
  const std::vector<Piece> pieces{gore(), band(), disc()};
  const Pattern pattern = reread(sheet_of(pieces));
  EXPECT_EQ(pattern.name, "gored skirt");
  EXPECT_EQ(pattern.style, "gored skirt");
  EXPECT_EQ(pattern.sample_size, "38");
  ASSERT_EQ(pattern.pieces.size(), pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) expect_same(pieces[i], pattern.pieces[i]);
}

TEST(DxfAamaRoundTrip, IsStableFromTheFirstRereadingOn) {
  const auto again = [](const Pattern& pattern) { return dxf_aama_bytes(sheet_of(pattern.pieces)); };
  const Pattern once = reread(sheet_of({gore(), band()}));
  const std::string twice = again(once);
  EXPECT_EQ(twice, again(reread(sheet_of(once.pieces))));
}

TEST(DxfAamaRoundTrip, KeepsASmallPatternInMillimetres) {  // METRIC below 150 mm would be taken for cm from anybody else
  const Piece small = band(.08, .03);
  const Pattern pattern = reread(sheet_of({small}));
  ASSERT_EQ(pattern.pieces.size(), 1u);
  expect_same(small, pattern.pieces[0]);
}

TEST(DxfAamaRoundTrip, KeepsGradeRuleNumbers) {
  Piece piece = band();
  piece.outline[0].points[0].grade_rule = 7;
  piece.outline[3].points[1].grade_rule = 7;
  const Pattern pattern = reread(sheet_of({piece}));
  ASSERT_EQ(pattern.pieces.size(), 1u);
  expect_same(piece, pattern.pieces[0]);
}

TEST(DxfAamaRoundTrip, ReadsTheSampleSizeOfTheNestItWrites) {
  CutSheet sheet = sheet_of({band(.7)});
  sheet.placed.push_back({cut_piece(band(.74), "40"), {0, 0}, 0});
  const Loaded<Pattern> loaded = read_dxf_aama_bytes(dxf_aama_bytes(sheet), "nest.dxf");
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  ASSERT_EQ(loaded.value->pieces.size(), 1u);
  expect_same(band(.7), loaded.value->pieces[0]);
  ASSERT_TRUE(find(loaded.report, "aama.nest"));
  EXPECT_NE(find(loaded.report, "aama.nest")->text.find("40"), std::string::npos);
}

TEST(DxfAamaRoundTrip, WritesAPiecePlacedTwiceOnce) {
  CutSheet sheet = sheet_of({band(), band()});
  EXPECT_EQ(reread(sheet).pieces.size(), 1u);
}

TEST(DxfAamaWriter, WritesSevenBitNamesThatStayApart) {
  Piece one = band(), two = band(.5);
  one.name = "Ärmel";
  two.name = "Aermel";
  const std::string bytes = dxf_aama_bytes(sheet_of({one, two}));
  for (const char c : bytes) EXPECT_LT(static_cast<unsigned char>(c), 0x80);
  const Pattern pattern = reread(sheet_of({one, two}));
  ASSERT_EQ(pattern.pieces.size(), 2u);
  EXPECT_EQ(pattern.pieces[0].name, "Aermel");
  EXPECT_EQ(pattern.pieces[1].name, "Aermel-2");
}

TEST(DxfAamaWriter, KeepsToTheProfile) {
  const std::string bytes = dxf_aama_bytes(sheet_of({gore(), band(), disc()}));
  EXPECT_EQ(bytes.find("TABLES"), std::string::npos);
  EXPECT_EQ(bytes.find("$"), std::string::npos);
  EXPECT_EQ(bytes.rfind("  0\nSECTION\n  2\nHEADER\n  0\nENDSEC\n  0\nSECTION\n  2\nBLOCKS\n", 0), 0u);
  EXPECT_NE(bytes.find("  2\nGORE_38\n 70\n64\n"), std::string::npos);
  EXPECT_NE(bytes.find("Units: METRIC\n"), std::string::npos);
  EXPECT_NE(bytes.find("Annotation: verified: 0.3 mm\n"), std::string::npos);
  EXPECT_NE(bytes.find("Quantity: 3,3\n"), std::string::npos);
  EXPECT_EQ(bytes.find(" 39\n0.0000"), std::string::npos);  // a width of 0 upsets other readers
  EXPECT_EQ(bytes.substr(bytes.size() - 8), "  0\nEOF\n");
  EXPECT_EQ(bytes, dxf_aama_bytes(sheet_of({gore(), band(), disc()})));
}

TEST(DxfAamaWriter, RefusesAPieceWithoutLines) {
  CutSheet sheet = sheet_of({band()});
  sheet.placed[0].cut.cut_line.clear();
  EXPECT_THROW(dxf_aama_bytes(sheet), std::invalid_argument);
  sheet = sheet_of({band()});
  sheet.placed[0].cut.piece.outline[0].points[0].at.x() = NAN;
  EXPECT_THROW(dxf_aama_bytes(sheet), std::invalid_argument);
}

TEST(DxfAamaWriter, LeavesNothingBehindWhereItMayNotWrite) {
  const auto nowhere = std::filesystem::temp_directory_path() / "toile-no-such-folder" / "x.dxf";
  EXPECT_THROW(write_dxf_aama(nowhere, sheet_of({band()})), BadInput);
  EXPECT_FALSE(std::filesystem::exists(nowhere.parent_path()));
}

TEST(AsciiNames, LoseAccentsButStayReadable) {
  EXPECT_EQ(aama::ascii("Ärmel rechts ß"), "Aermel rechts ss");
  EXPECT_EQ(aama::ascii("Manche été – n° 2"), "Manche ete - n deg 2");
  EXPECT_EQ(aama::ascii("Żakiet"), "Zakiet");
  EXPECT_EQ(aama::ascii("\xC4rmel"), "Aermel");  // Latin-1
  EXPECT_EQ(aama::ascii("two\nlines\t"), "two lines");
  EXPECT_EQ(aama::ascii("袖"), "_");
  EXPECT_EQ(aama::block_name("front / left*"), "FRONT___LEFT_");
  EXPECT_EQ(aama::block_name(std::string(60, 'a')).size(), 31u);
  EXPECT_EQ(aama::block_name(""), "PIECE");
}

TEST(ReadPattern, TellsFormatsByExtensionThenByContent) {
  const auto folder = std::filesystem::temp_directory_path() / ("toile-formats-test-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto save = [&](const char* name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return folder / name;
  };
  const std::string dxf = dxf_aama_bytes(sheet_of({band()}));
  EXPECT_TRUE(read_pattern(save("band.DXF", dxf)).value);
  EXPECT_TRUE(read_pattern(save("band.txt", dxf)).value);
  const Loaded<Pattern> unknown = read_pattern(save("band.doc", "a letter"));
  ASSERT_TRUE(find(unknown.report, "format.unknown"));
  EXPECT_NE(find(unknown.report, "format.unknown")->remedy.find("GarmentCode"), std::string::npos);
  EXPECT_TRUE(find(read_pattern(folder / "missing.dxf").report, "file.missing"));
  EXPECT_FALSE(read_pattern(save("broken.json", "{")).value);
  EXPECT_TRUE(find(read_pattern(save("binary.dxf", "AutoCAD Binary DXF\r\n")).report, "dxf.binary"));

  const Loaded<Pattern> half = read_pattern(folder / "band.DXF", {0.5e-3, {}});
  ASSERT_TRUE(half.value);
  EXPECT_NEAR(length(half.value->pieces[0].outline[0]), .35, 1e-5);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace toile
