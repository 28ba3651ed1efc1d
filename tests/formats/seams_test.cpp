#include "formats/seams/seams.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "formats/seams_skirt.h"
#include "garment/units.h"

namespace toile {
namespace {

TEST(Sidecar, SetsCopiesHemsAndAllowances) {
  const auto pattern = applied(pieces +
                                   "[[piece]]\nname = \"LOOP\"\ncopies = 2\nmirrored_copies = 2\nallowance = \"5 mm\"\n"
                                   "allowances = { e1 = \"3 cm\" }\nhems = [\"e1\"]\n",
                               [] {
                                 Pattern p = skirt();
                                 p.pieces.push_back(polygon("LOOP", {{0, 0}, {.1, 0}, {.1, .1}}));
                                 return p;
                               }());
  const Piece& loop = pattern.pieces[2];
  EXPECT_EQ(copies(loop), 4);
  EXPECT_EQ(loop.outline[0].seam_allowance, 5e-3);
  EXPECT_EQ(loop.outline[1].seam_allowance, 3e-2);
  EXPECT_TRUE(loop.outline[1].hem);
  EXPECT_FALSE(loop.outline[0].hem);
}

TEST(Sidecar, SaysWhichPiecesAreNotSewn) {
  const auto with_pocket = [] {
    Pattern p = skirt();
    p.pieces.push_back(polygon("POCKET", {{0, 0}, {.1, 0}, {.1, .1}}));
    return p;
  };
  const std::string not_sewn = "[[piece]]\nname = \"pocket\"\nsewn = false\n";
  const auto pattern = applied(pieces + not_sewn, with_pocket());
  EXPECT_FALSE(pattern.pieces[2].sewn);
  EXPECT_TRUE(pattern.pieces[0].sewn);
  EXPECT_EQ(first_finding(not_sewn + "[[seam]]\na = \"POCKET.e0\"\nb = \"BAND.e0[0..10 cm]\"\n", with_pocket()).code,
            "seam.not-sewn");
}

TEST(Sidecar, SaysWhichLayerAPieceIs) {
  const auto pattern = applied("[[piece]]\nname = \"gore\"\nlayer = 1\n");
  EXPECT_EQ(pattern.pieces[0].layer, 1);
  EXPECT_FALSE(pattern.pieces[1].layer);
  EXPECT_NE(seams_text(pattern).find("\nlayer = 1\n"), std::string::npos);
  EXPECT_EQ(first_finding(one_piece("layer = -1\n")).code, "seams.bad-value");
}

TEST(Sidecar, SpreadsCopiesRoundTheBody) {
  const auto pattern = applied(one_piece("on = { level = \"waist\", drop = \"4 cm\", around = true }\n"));
  const auto& on = pattern.pieces[0].body_part;
  ASSERT_EQ(on.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const BodyPart& part = *on[static_cast<std::size_t>(k)];
    EXPECT_EQ(part.part, "trunk");
    EXPECT_NEAR(part.drop, .04, 1e-12);
    EXPECT_NEAR(std::remainder(part.angle - (45 + 90 * k) * units::degree, 2 * std::numbers::pi), 0, 1e-12);
    EXPECT_LE(std::abs(part.angle), std::numbers::pi + 1e-12);
  }
  const auto first = applied(one_piece("on = { around = true, first = \"0 deg\" }\n"));
  EXPECT_NEAR(first.pieces[0].body_part[0]->angle, 0, 1e-12);
  EXPECT_NEAR(first.pieces[0].body_part[1]->angle, std::numbers::pi / 2, 1e-12);
}

TEST(Sidecar, AMirroredCopySitsOnTheOtherSide) {
  Pattern pattern;
  pattern.pieces = {polygon("SLEEVE", {{0, 0}, {.1, 0}, {.1, .1}}, 1, 1)};
  pattern =
      applied("[[piece]]\nname = \"SLEEVE\"\non = { part = \"arm.L\", level = \"shoulder\", angle = \"20 deg\" }\n", pattern);
  EXPECT_EQ(pattern.pieces[0].body_part[0]->part, "arm.L");
  EXPECT_EQ(pattern.pieces[0].body_part[1]->part, "arm.R");
  EXPECT_NEAR(pattern.pieces[0].body_part[1]->angle, -20 * units::degree, 1e-12);
}

TEST(Sidecar, TakesOnePlaceForEachCopy) {
  const auto pattern = applied(one_piece("on = [{ angle = \"0 deg\" }, { angle = \"90 deg\" }, {}, { part = \"leg.L\" }]\n"));
  EXPECT_NEAR(pattern.pieces[0].body_part[1]->angle, std::numbers::pi / 2, 1e-12);
  EXPECT_FALSE(pattern.pieces[0].body_part[2]);
  EXPECT_EQ(pattern.pieces[0].body_part[3]->part, "leg.L");
  EXPECT_EQ(first_finding(one_piece("on = [{ angle = \"0 deg\" }]\n")).code, "seam.copies");
  EXPECT_EQ(first_finding(one_piece("on = { part = \"tail\" }\n")).code, "seam.unknown-part");
  EXPECT_EQ(first_finding(one_piece("on = { angle = 90 }\n")).code, "seams.bad-value");
  EXPECT_EQ(first_finding(one_piece("on = { angle = \"90 deg\", around = true }\n")).code, "seams.bad-value");
  EXPECT_EQ(first_finding(one_piece("on = { height = \"1 m\" }\n")).code, "seam.unknown-key");
}

TEST(Seams, RunAgainstEachOtherUnlessReversed) {
  const auto pattern = applied(one_seam("a = \"gore:1.right\"\nb = \"Gore:2.left\"\n"));
  ASSERT_EQ(pattern.seams.size(), 1u);
  EXPECT_EQ(pattern.seams[0].a, (EdgeSpan{"GORE", 1, "right", 0, 1}));
  EXPECT_EQ(pattern.seams[0].b, (EdgeSpan{"GORE", 2, "left", 1, 0}));
  EXPECT_EQ(pattern.seams[0].name, "GORE:1.right to GORE:2.left");
  const auto reversed =
      applied(one_seam("a = \"gore:1.right\"\nb = \"gore:2.left\"\nreversed = true\nright_to_wrong = true\n"));
  EXPECT_EQ(reversed.seams[0].b, (EdgeSpan{"GORE", 2, "left", 0, 1}));
  EXPECT_TRUE(reversed.seams[0].right_to_wrong);
}

TEST(Seams, AMirroredCopyIsSewnTheSameWayRound) {
  // Centre front of a piece cut as a pair: both copies' edges run upwards as drawn.
  Pattern pattern;
  pattern.pieces = {polygon("FRONT", {{0, 0}, {.2, 0}, {.2, .5}, {0, .5}}, 1, 1)};
  pattern = applied("[[seam]]\na = \"FRONT:1.e1\"\nb = \"FRONT:2.e1\"\n", pattern);
  EXPECT_EQ(pattern.seams[0].b, (EdgeSpan{"FRONT", 2, "e1", 0, 1}));
}

TEST(Seams, ARingJoinsEachCopyToTheNext) {
  const auto pattern = applied(one_seam("ring = \"gore\"\nfrom = \"right\"\nto = \"left\"\nname = \"gore\"\n"));
  ASSERT_EQ(pattern.seams.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const Seam& seam = pattern.seams[static_cast<std::size_t>(k)];
    EXPECT_EQ(seam.name, "gore " + std::to_string(k + 1));
    EXPECT_EQ(seam.a, (EdgeSpan{"GORE", k + 1, "right", 0, 1}));
    EXPECT_EQ(seam.b, (EdgeSpan{"GORE", (k + 1) % 4 + 1, "left", 1, 0}));
  }
  EXPECT_EQ(applied(one_seam("ring = \"gore\"\nfrom = \"right\"\nto = \"left\"\nopen = true\n")).seams.size(), 3u);
  EXPECT_EQ(applied(one_seam("ring = \"band\"\nfrom = \"right\"\nto = \"left\"\n")).seams.size(), 1u);
}

TEST(Seams, AlongSharesOneEdgeOutInProportion) {
  const auto pattern = applied(one_seam("along = \"band.bottom\"\neach = \"gore.top\"\n"));
  ASSERT_EQ(pattern.seams.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const Seam& seam = pattern.seams[static_cast<std::size_t>(k)];
    EXPECT_NEAR(seam.a.begin, k / 4.0, 1e-12);
    EXPECT_NEAR(seam.a.end, (k + 1) / 4.0, 1e-12);
    EXPECT_EQ(seam.b, (EdgeSpan{"GORE", k + 1, "top", 1, 0}));
  }
  EXPECT_EQ(pattern.seams[3].a.end, 1);
  const auto unequal =
      applied(one_seam("along = \"band.bottom\"\neach = [\"gore:1.top\", \"gore:2.hem\"]\nease = \"10 cm\"\n"));
  EXPECT_NEAR(unequal.seams[0].a.end, 1 / 3.0, 1e-12);
  const auto backwards = applied(one_seam("along = \"band.bottom\"\neach = \"gore.top\"\nbackwards = true\n"));
  EXPECT_EQ(backwards.seams[0].b.copy, 4);
}

TEST(Seams, AlongMayBeginElsewhereAndRunOverTheEnd) {
  const auto pattern = applied(one_seam("along = \"band.bottom\"\neach = \"gore.top\"\nstart = \"1/16\"\n"));
  ASSERT_EQ(pattern.seams.size(), 5u);
  EXPECT_NEAR(pattern.seams[0].a.begin, 1 / 16.0, 1e-12);
  // The last gore is sewn three quarters before the end of the band and one quarter at its beginning, right to left.
  const Seam &before = pattern.seams[3], &after = pattern.seams[4];
  EXPECT_NEAR(before.a.begin, 13 / 16.0, 1e-12);
  EXPECT_EQ(before.a.end, 1);
  EXPECT_NEAR(before.b.begin, 1, 1e-12);
  EXPECT_NEAR(before.b.end, .25, 1e-12);
  EXPECT_NEAR(after.a.begin, 0, 1e-12);
  EXPECT_NEAR(after.a.end, 1 / 16.0, 1e-12);
  EXPECT_NEAR(after.b.begin, .25, 1e-12);
  EXPECT_NEAR(after.b.end, 0, 1e-12);
  double sewn = 0;
  for (const Seam& seam : pattern.seams) {
    sewn += span_length(pattern, seam.a);
    EXPECT_NEAR(span_length(pattern, seam.a), span_length(pattern, seam.b), 1e-12);
  }
  EXPECT_NEAR(sewn, .4, 1e-12);
}

TEST(Seams, RunsMayBeGivenByLengthAndAsTables) {
  const auto pattern = applied(one_seam(
      "a = { piece = \"BAND\", edge = \"bottom\", from = \"10 cm\", to = \"20 cm\" }\nb = \"gore:2.top[start..end]\"\n"));
  EXPECT_EQ(pattern.seams[0].a, (EdgeSpan{"BAND", 1, "bottom", .25, .5}));
}

TEST(Seams, UnequalLengthsAreAWarningUnlessTheyAreEased) {
  const Finding f = first_finding(one_seam("a = \"gore:1.top\"\nb = \"gore:2.hem\"\n"));
  EXPECT_EQ(f.code, "seam.length");
  EXPECT_EQ(f.severity, Severity::warning);
  EXPECT_EQ(f.place, "skirt.seams.toml:8");
  EXPECT_NE(f.text.find("100.0 mm apart"), std::string::npos) << f.text;
  EXPECT_EQ(first_finding(one_seam("a = \"gore:1.top\"\nb = \"gore:2.hem\"\nease = \"9 cm\"\n")).code, "seam.length");
  for (const char* ease : {"10 cm", "100 %"}) {
    Pattern pattern = skirt();
    const auto text = one_seam(std::string("a = \"gore:1.top\"\nb = \"gore:2.hem\"\nease = \"") + ease + "\"\n");
    EXPECT_TRUE(apply_seams(pattern, text, "x").findings.empty()) << ease;
  }
}

TEST(Seams, WhatDoesNotExistIsNamedWithItsLineAndWhatThereIs) {
  const Finding edge = first_finding(one_seam("a = \"gore:1.sidee\"\nb = \"gore:2.left\"\n"));
  EXPECT_EQ(edge.code, "seam.unknown-edge");
  EXPECT_EQ(edge.place, "skirt.seams.toml:9");
  EXPECT_NE(edge.remedy.find("hem, right, top, left"), std::string::npos) << edge.remedy;
  const Finding piece = first_finding(one_seam("a = \"gore:1.right\"\nb = \"yoke.left\"\n"));
  EXPECT_EQ(piece.code, "seam.unknown-piece");
  EXPECT_EQ(piece.place, "skirt.seams.toml:10");
  EXPECT_NE(piece.remedy.find("GORE (4 copies), BAND"), std::string::npos) << piece.remedy;
  EXPECT_EQ(first_finding(one_seam("a = \"gore:5.right\"\nb = \"gore:1.left\"\n")).code, "seam.unknown-copy");
  EXPECT_EQ(first_finding(one_seam("a = \"gore.right\"\nb = \"gore:1.left\"\n")).code, "seam.unknown-copy");
  EXPECT_EQ(first_finding(one_seam("ring = \"gore\"\nfrom = \"right\"\nto = \"side\"\n")).code, "seam.unknown-edge");
  EXPECT_EQ(first_finding("[[piece]]\nname = \"YOKE\"\n").code, "seam.unknown-piece");
}

TEST(Seams, SlipsOfThePenAreNamedWithTheirLine) {
  EXPECT_EQ(first_finding("[[piece\n").code, "toml.syntax");
  EXPECT_EQ(first_finding("[[piece]]\nname = GORE\n").place.substr(0, 18), "skirt.seams.toml:2");
  EXPECT_EQ(first_finding("[[piece]]\ncopies = 2\n").code, "seam.syntax");
  EXPECT_EQ(first_finding("[[seams]]\na = \"x\"\n").code, "seam.unknown-key");
  EXPECT_EQ(first_finding("[piece]\nname = \"GORE\"\n").code, "seams.bad-value");
  EXPECT_EQ(first_finding(one_piece("copies = 0\n")).code, "seam.copies");
  EXPECT_EQ(first_finding(one_piece("copies = \"two\"\n")).code, "seams.bad-value");
  EXPECT_EQ(first_finding(one_piece("allowance = 1\n")).code, "seams.bad-value");
  EXPECT_EQ(first_finding(one_piece("hems = [\"bottom\"]\n")).code, "seam.unknown-edge");
  EXPECT_EQ(first_finding(one_seam("a = \"gore:1.right\"\n")).code, "seam.syntax");
  EXPECT_EQ(first_finding(one_seam("a = \"gore:1/right\"\nb = \"gore:2.left\"\n")).code, "seam.syntax");
  EXPECT_EQ(first_finding(one_seam("a = \"gore:1.right[1..0]\"\nb = \"gore:2.left\"\n")).code, "seam.range");
  EXPECT_EQ(first_finding(one_seam("a = \"gore:1.right[0..2 m]\"\nb = \"gore:2.left\"\n")).code, "seam.range");
  EXPECT_EQ(first_finding(one_seam("a = \"gore:1.right\"\nb = \"gore:2.left\"\nreverse = true\n")).code, "seam.unknown-key");
}

TEST(Seams, SewingARunTwiceIsSaid) {
  const Finding f =
      first_finding(one_seam("a = \"gore:1.right\"\nb = \"gore:2.left\"\n[[seam]]\na = \"gore:1.right[0..1/2]\"\nb = "
                             "\"gore:3.left[1/2..1]\"\n"));
  EXPECT_EQ(f.code, "seam.edge-twice");
  EXPECT_EQ(f.severity, Severity::note);
}

TEST(Seams, AMissingSidecarIsAFinding) {
  Pattern pattern = skirt();
  const Report report = apply_seams(pattern, std::filesystem::path("/nonexistent/skirt.seams.toml"));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings[0].fault, Fault::missing);
}

}  // namespace
}  // namespace toile
