// Letters and codes of texts, and what else a DXF says that is not read.

#include <gtest/gtest.h>

#include "formats/dxf/code_page.h"
#include "formats/dxf/drawing.h"
#include "formats/dxf/text_codes.h"
#include "formats/dxf_aama/dxf_aama.h"
#include "formats/dxf_text.h"
#include "formats/formats.h"

namespace toile::dxf {
namespace {

std::string decoded(const std::string& page, const std::string& bytes, Report* report = nullptr) {
  std::vector<Tag> tags{{9, "$DWGCODEPAGE", 1}, {3, page, 3}, {1, bytes, 5}};
  if (page.empty()) tags.erase(tags.begin(), tags.begin() + 2);
  Report own;
  decode(tags, "x.dxf", report ? *report : own);
  return tags.back().value;
}

TEST(DxfCodePage, LettersAreReadInTheCodePageOfTheHeader) {
  Report report;
  EXPECT_EQ(decoded("ANSI_1252", "\xC4rmel \x80", &report), "Ärmel €");
  ASSERT_TRUE(find(report, "dxf.code-page"));
  EXPECT_EQ(find(report, "dxf.code-page")->severity, Severity::note);
  EXPECT_EQ(decoded("ansi_1251", "\xD0\xF3\xEA\xE0\xE2"), "Рукав");
  EXPECT_EQ(decoded("ANSI_1250", "r\xF8k\xE1v"), "rřkáv");
  EXPECT_EQ(decoded("dos850", "\x8Ermel"), "Ärmel");
  EXPECT_EQ(decoded("ANSI_932", "\x91\xB3"), "袖");
  EXPECT_EQ(decoded("", "\xC4rmel"), "Ärmel");
}

TEST(DxfCodePage, Utf8AndAsciiStayAsTheyAre) {
  Report report;
  EXPECT_EQ(decoded("ANSI_1252", "Ärmel", &report), "Ärmel");
  EXPECT_EQ(decoded("ANSI_1252", "sleeve", &report), "sleeve");
  EXPECT_TRUE(report.findings.empty());
}

TEST(DxfCodePage, WhatCannotBeReadIsSaid) {
  Report lacking, unknown;
  EXPECT_EQ(decoded("ANSI_1252", "\xC4 \x81r", &lacking), "Ä \uFFFDr");  // 81 is no letter there
  EXPECT_EQ(decoded("KLINGON_7", "\xC4r", &unknown), "Är");
  for (const Report* report : {&lacking, &unknown}) {
    ASSERT_TRUE(find(*report, "dxf.code-page"));
    EXPECT_EQ(find(*report, "dxf.code-page")->severity, Severity::warning);
  }
}

TEST(DxfTextCodes, AreReadAsWhatTheyShow) {
  EXPECT_EQ(plain_text("cut at 45%%d %%p2 %%c8 100%%% %%uunder%%u %%065", false), "cut at 45° ±2 ⌀8 100% under A");
  EXPECT_EQ(plain_text("\\U+00C4rmel \\U+8896", false), "Ärmel 袖");
  EXPECT_EQ(plain_text("C:\\Patterns {x}; 50%", false), "C:\\Patterns {x}; 50%");
  EXPECT_EQ(plain_text("{\\fArial|b0|i0|c0|p34;Piece Name: \\H2.5x;front}\\PSize:\\~38", true), "Piece Name: front\nSize: 38");
  EXPECT_EQ(plain_text("\\A1;\\C3;\\Lunder\\l \\S1/2; \\S3#4; a\\\\b \\{c\\}^Jd^Ie", true), "under 1/2 3/4 a\\b {c}\nd e");
  EXPECT_EQ(plain_text("\\fArial without end", true), "\\fArial without end");
  EXPECT_EQ(plain_text("ends in \\", true), "ends in \\");
  EXPECT_EQ(plain_text("%%", false), "%%");
}

TEST(DxfTextCodes, AnMtextWithSeveralKeysIsSeveralTexts) {
  const std::string mtext = tag(0, "MTEXT") + tag(8, "1") + tag(10, "0") + tag(20, "0") + tag(3, "{\\fArial;Piece Name: fro") +
                            tag(1, "nt}\\PQuantity: 2\\P\\PMaterial: denim");
  const auto loaded = read_dxf_pattern_bytes(
      pattern_file(block("B", mtext + polyline_on("1", rectangle(0, 0, 300, 400), true)), {"Units: METRIC"}), "x.dxf", {});
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  const Piece& piece = loaded.value->pattern.pieces.at(0);
  EXPECT_EQ(piece.name, "front");
  EXPECT_EQ(piece.quantity, 2);
  EXPECT_EQ(piece.material, "denim");
  EXPECT_TRUE(piece.annotations.empty());
}

TEST(DxfLosses, ArraysAndDatesAreSaid) {
  const std::string array = tag(0, "INSERT") + tag(8, "1") + tag(2, "B") + tag(10, "0") + tag(20, "0") + tag(70, "3") +
                            tag(71, "2") + tag(44, "400") + tag(45, "500");
  const std::string bytes =
      section("BLOCKS", block("B", polyline_on("1", rectangle(0, 0, 300, 400), true))) +
      section("ENTITIES", text_on("1", "Units: METRIC") + text_on("1", "Creation Date: 1-4-2020") + array) + tag(0, "EOF");
  const auto loaded = read_dxf_pattern_bytes(bytes, "x.dxf", {});
  ASSERT_TRUE(loaded.value) << all_words(loaded.report);
  ASSERT_TRUE(find(loaded.report, "dxf.insert-array"));
  EXPECT_NE(find(loaded.report, "dxf.insert-array")->text.find("3 by 2"), std::string::npos);
  ASSERT_TRUE(find(loaded.report, "aama.style-date"));
  EXPECT_NE(find(loaded.report, "aama.style-date")->text.find("1-4-2020"), std::string::npos);
}

}  // namespace
}  // namespace toile::dxf
