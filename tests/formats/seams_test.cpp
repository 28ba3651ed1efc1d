#include "formats/seams/seams.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "formats/formats.h"
#include "formats/garmentcode/garmentcode.h"
#include "formats/seams/span_text.h"
#include "garment/units.h"

namespace toile {
namespace {

Piece polygon(const std::string& name, const std::vector<Eigen::Vector2d>& corners, int quantity = 1, int mirrored = 0) {
  Piece piece;
  piece.name = name;
  piece.quantity = quantity;
  piece.mirrored_quantity = mirrored;
  for (std::size_t k = 0; k < corners.size(); ++k)
    piece.outline.push_back(
        {"e" + std::to_string(k), {{corners[k], true, {}}, {corners[(k + 1) % corners.size()], true, {}}}, {}, false});
  return piece;
}

// Four gores 20 cm wide at the hem and 10 cm at the top, 50 cm high, whose outline begins at the top right; a band 40 x 4 cm.
Pattern skirt() {
  Pattern pattern;
  pattern.pieces = {polygon("GORE", {{.15, .5}, {.05, .5}, {0, 0}, {.2, 0}}, 4),
                    polygon("BAND", {{0, 0}, {.4, 0}, {.4, .04}, {0, .04}})};
  pattern.pieces[0].notches = {{"e1", .25, NotchKind::slit, 4e-3, 0}};
  return pattern;
}

const std::string pieces = R"([[piece]]
name = "gore"
start = "bottom left"
edges = ["hem", "right", "top", "left"]
[[piece]]
name = "BAND"
edges = ["bottom", "right", "top", "left"]
)";

Pattern applied(const std::string& text, Pattern pattern = skirt()) {
  const Report report = apply_seams(pattern, text, "skirt.seams.toml");
  for (const Finding& f : report.findings) EXPECT_NE(f.severity, Severity::error) << in_words(f);
  return pattern;
}

Finding first_finding(const std::string& text, Pattern pattern = skirt()) {
  const Pattern before = pattern;
  const Report report = apply_seams(pattern, text, "skirt.seams.toml");
  if (!report.ok()) {
    EXPECT_EQ(pattern, before) << "changed in spite of an error";
  }
  if (report.findings.empty()) {
    ADD_FAILURE() << "no finding for\n" << text;
    return {};
  }
  return report.findings[0];
}

std::string one_piece(const std::string& lines) { return "[[piece]]\nname = \"GORE\"\n" + lines; }
std::string one_seam(const std::string& lines) { return pieces + "[[seam]]\n" + lines; }

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

TEST(Seams, SewingARunTwiceIsAWarning) {
  const Finding f =
      first_finding(one_seam("a = \"gore:1.right\"\nb = \"gore:2.left\"\n[[seam]]\na = \"gore:1.right[0..1/2]\"\nb = "
                             "\"gore:3.left[1/2..1]\"\n"));
  EXPECT_EQ(f.code, "seam.edge-twice");
}

TEST(Seams, AMissingSidecarIsAFinding) {
  Pattern pattern = skirt();
  const Report report = apply_seams(pattern, std::filesystem::path("/nonexistent/skirt.seams.toml"));
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings[0].fault, Fault::missing);
}

// The pattern as a reader finds it in a DXF: edges numbered, outlines beginning elsewhere, nothing else known.
Pattern stripped(Pattern pattern, const Eigen::Vector2d& shift, std::size_t begin_later_by) {
  for (Piece& piece : pattern.pieces) {
    std::rotate(piece.outline.begin(),
                piece.outline.begin() + static_cast<std::ptrdiff_t>(begin_later_by % piece.outline.size()),
                piece.outline.end());
    for (std::size_t k = 0; k < piece.outline.size(); ++k) {
      Edge& edge = piece.outline[k];
      for (Notch& notch : piece.notches)
        if (notch.edge == edge.id) notch.edge = "n" + std::to_string(k);
      edge.id = "n" + std::to_string(k);
      edge.hem = false;
      edge.seam_allowance.reset();
      for (OutlinePoint& point : edge.points) point.at += shift;
    }
    piece.body_part.clear();
    piece.placement.clear();
    piece.quantity = 1;
    piece.mirrored_quantity = 0;
  }
  pattern.seams.clear();
  return pattern;
}

void expect_same_sewing(const Pattern& got, const Pattern& wanted) {
  EXPECT_EQ(got.seams, wanted.seams);
  ASSERT_EQ(got.pieces.size(), wanted.pieces.size());
  for (std::size_t i = 0; i < got.pieces.size(); ++i) {
    const Piece &a = got.pieces[i], &b = wanted.pieces[i];
    SCOPED_TRACE(b.name);
    EXPECT_EQ(a.quantity, b.quantity);
    EXPECT_EQ(a.mirrored_quantity, b.mirrored_quantity);
    EXPECT_EQ(a.notches, b.notches);
    ASSERT_EQ(a.outline.size(), b.outline.size());
    for (const Edge& edge : b.outline) {
      const Edge* same = find_edge(a, edge.id);
      ASSERT_TRUE(same) << edge.id;
      EXPECT_EQ(same->hem, edge.hem);
      EXPECT_NEAR(same->seam_allowance.value_or(-1), edge.seam_allowance.value_or(-1), 1e-12);
      EXPECT_NEAR(length(*same), length(edge), 1e-12);
    }
    ASSERT_EQ(a.body_part.size(), b.body_part.size());
    for (std::size_t k = 0; k < a.body_part.size(); ++k) {
      ASSERT_EQ(a.body_part[k].has_value(), b.body_part[k].has_value());
      if (!a.body_part[k]) continue;
      EXPECT_EQ(a.body_part[k]->part, b.body_part[k]->part);
      EXPECT_EQ(a.body_part[k]->level, b.body_part[k]->level);
      EXPECT_NEAR(a.body_part[k]->angle, b.body_part[k]->angle, 1e-14);
      EXPECT_NEAR(a.body_part[k]->drop, b.body_part[k]->drop, 1e-14);
    }
    ASSERT_EQ(a.placement.size(), b.placement.size());
    for (std::size_t k = 0; k < a.placement.size(); ++k) {
      ASSERT_EQ(a.placement[k].has_value(), b.placement[k].has_value());
      if (!a.placement[k]) continue;
      EXPECT_LT((a.placement[k]->rotation - b.placement[k]->rotation).norm(), 1e-12);
      EXPECT_LT((a.placement[k]->translation - b.placement[k]->translation).norm(), 1e-12);
    }
  }
}

TEST(WriteSeams, ReadsBackAsTheSame) {
  Pattern pattern =
      applied(one_seam("ring = \"gore\"\nfrom = \"right\"\nto = \"left\"\nname = \"gore\"\n"
                       "[[seam]]\nalong = \"band.bottom\"\neach = \"gore.top\"\nstart = \"37 mm\"\nname = \"waist\"\n"
                       "[[seam]]\nname = \"back \\\"\"\na = \"band.left\"\nb = \"band.right\"\nreversed = true\n"
                       "right_to_wrong = true\n[[piece]]\nname = \"FRONT 1.5\"\nallowance = \"7 mm\"\nhems = [\"e0\"]\n"
                       "on = { part = \"leg.R\", level = \"hip\", drop = \"33 mm\", angle = \"12.3 deg\" }\n"
                       "[[seam]]\nname = \"cf\"\na = \"FRONT 1.5:1.e1[1/3..1/2]\"\nb = \"FRONT 1.5:2.e1\"\n"),
              [] {
                Pattern p = skirt();
                p.pieces.push_back(polygon("FRONT 1.5", {{0, 0}, {.2, 0}, {.2, .5}, {.05, .45}}, 1, 1));
                return p;
              }());
  pattern.pieces[0].placement = {
      std::nullopt,
      Placement{Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, .5).normalized()).toRotationMatrix(), {.1, 1.2, -.3}},
      Placement{Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()).toRotationMatrix(), {0, 1, 0}}, std::nullopt};
  for (std::size_t later = 0; later < 4; ++later) {
    Pattern back = stripped(pattern, {.3, -.2}, later);
    const Report report = apply_seams(back, seams_text(pattern), "skirt.seams.toml");
    for (const Finding& f : report.findings) ADD_FAILURE() << in_words(f) << "\n" << seams_text(pattern);
    expect_same_sewing(back, pattern);
  }
}

TEST(WriteSeams, RealGarmentsReadBackAsTheSame) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(corpus) / "patterns/garmentcode/mh_f38")) {
    SCOPED_TRACE(entry.path().filename());
    const Pattern pattern = *read_garmentcode(entry.path()).value;
    Pattern back = stripped(pattern, {0, 0}, 2);
    const Report report = apply_seams(back, seams_text(pattern), "x.seams.toml");
    for (const Finding& f : report.findings) ADD_FAILURE() << in_words(f);
    expect_same_sewing(back, pattern);
  }
}

}  // namespace
}  // namespace toile
