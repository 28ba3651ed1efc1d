// What is written as GarmentCode specification is read again as it was.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "formats/garmentcode/curve_fit.h"
#include "formats/garmentcode/curves.h"
#include "formats/garmentcode/garmentcode.h"

namespace toile {
namespace {

using Eigen::Vector2d;

Pattern read_again(const Pattern& pattern) {
  const auto [text, losses] = garmentcode_text(pattern);
  const auto read = read_garmentcode_text(text, pattern.name + "_specification.json");
  EXPECT_TRUE(read.value) << in_words(read.report.findings.front());
  for (const Finding& finding : read.report.findings) EXPECT_NE(finding.code, "garmentcode.unknown-keys") << finding.text;
  return read.value ? read.value->pattern : Pattern{};
}

// Begin and end of both sides may be given from either end.
Seam sorted(Seam seam) {
  if (seam.a.begin > seam.a.end) {
    std::swap(seam.a.begin, seam.a.end);
    std::swap(seam.b.begin, seam.b.end);
  }
  return seam;
}

void expect_same(const Pattern& pattern, const Pattern& again, double near) {
  ASSERT_EQ(again.pieces.size(), pattern.pieces.size());
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    const Piece &piece = pattern.pieces[p], &other = again.pieces[p];
    EXPECT_EQ(other.name, piece.name);
    ASSERT_EQ(other.outline.size(), piece.outline.size()) << piece.name;
    for (std::size_t e = 0; e < piece.outline.size(); ++e) {
      const Edge &edge = piece.outline[e], &same = other.outline[e];
      EXPECT_EQ(same.id, edge.id) << piece.name;
      ASSERT_EQ(same.points.size(), edge.points.size()) << piece.name << "." << edge.id;
      for (std::size_t i = 0; i < edge.points.size(); ++i) {
        EXPECT_LE((same.points[i].at - edge.points[i].at).norm(), near) << piece.name << "." << edge.id;
        EXPECT_EQ(same.points[i].turn, edge.points[i].turn);
      }
    }
    ASSERT_EQ(other.placement.size(), piece.placement.size());
    for (std::size_t c = 0; c < piece.placement.size(); ++c) {
      EXPECT_TRUE(other.placement[c]->rotation.isApprox(piece.placement[c]->rotation, 1e-9)) << piece.name;
      EXPECT_LE((other.placement[c]->translation - piece.placement[c]->translation).norm(), 1e-9);
    }
  }
  ASSERT_EQ(again.seams.size(), pattern.seams.size());
  for (std::size_t s = 0; s < pattern.seams.size(); ++s) {
    Seam wanted = sorted(pattern.seams[s]), got = sorted(again.seams[s]);
    got.name = wanted.name;
    EXPECT_EQ(got, wanted) << wanted.name;
  }
}

TEST(CurveFit, FindsTheCurveThatPointsWereSampledFrom) {
  const Vector2d from(0, 0), to(.3, .1);
  const auto with_ends = [&](std::vector<Vector2d> between) {
    between.insert(between.begin(), from);
    between.push_back(to);
    return between;
  };
  const FittedCurve quadratic = fit_curve(with_ends(bezier_between({from, {.1, .2}, to}, 1e-5)));
  EXPECT_EQ(quadratic.kind, FittedCurve::Kind::quadratic);
  EXPECT_LT((quadratic.control[0] - Vector2d(.1, .2)).norm(), 1e-9);
  const FittedCurve cubic = fit_curve(with_ends(bezier_between({from, {.05, .2}, {.3, -.1}, to}, 1e-5)));
  EXPECT_EQ(cubic.kind, FittedCurve::Kind::cubic);
  EXPECT_LT((cubic.control[1] - Vector2d(.3, -.1)).norm(), 1e-9);
  for (const bool large : {false, true})
    for (const bool right : {false, true}) {
      const FittedCurve circle = fit_curve(with_ends(arc_between(from, to, .2, large, right, 1e-5)));
      EXPECT_EQ(circle.kind, FittedCurve::Kind::circle);
      EXPECT_NEAR(circle.radius, .2, 1e-9);
      EXPECT_EQ(circle.large, large);
      EXPECT_EQ(circle.right, right);
    }
  EXPECT_EQ(fit_curve({from, .5 * to, to}).kind, FittedCurve::Kind::line);
  EXPECT_GT(fit_curve({from, {.05, .1}, {.1, -.1}, {.15, .1}, {.2, -.1}, {.25, .1}, to}).departure, 1e-3);
}

// A skirt front with a dart sewn to itself, gathered to a band that it meets with half of one edge, cut as drawn and mirrored.
TEST(WriteGarmentCode, SplitsEdgesWhereTheFormatNeedsIt) {
  const auto edge = [](const char* id, std::vector<Vector2d> at) {
    Edge made;
    made.id = id;
    for (std::size_t i = 0; i < at.size(); ++i) made.points.push_back({at[i], i == 0 || i + 1 == at.size(), {}});
    return made;
  };
  Pattern pattern;
  pattern.name = "skirt";
  Piece front;
  front.name = "front";
  front.quantity = 1;
  front.mirrored_quantity = 1;
  front.outline = {edge("hem", {{0, 0}, {.3, 0}}),      edge("side", {{.3, 0}, {.3, .6}}),   edge("top", {{.3, .6}, {.2, .6}}),
                   edge("leg1", {{.2, .6}, {.15, .5}}), edge("leg2", {{.15, .5}, {.1, .6}}), edge("top2", {{.1, .6}, {0, .6}}),
                   edge("middle", {{0, .6}, {0, 0}})};
  Piece band;
  band.name = "band";
  band.outline = {edge("e0", {{0, 0}, {.3, 0}}), edge("e1", {{.3, 0}, {.3, .04}}), edge("e2", {{.3, .04}, {0, .04}}),
                  edge("e3", {{0, .04}, {0, 0}})};
  pattern.pieces = {front, band};
  pattern.seams = {{"dart", {"front", 1, "leg1", 0, 1}, {"front", 1, "leg2", 1, 0}, false},
                   {"band", {"front", 1, "top", 0, 1}, {"band", 1, "e0", .5, 0}, false},
                   {"middle", {"front", 1, "middle", 0, 1}, {"front", 2, "middle", 0, 1}, false}};
  const auto [text, losses] = garmentcode_text(pattern);
  const Pattern again = read_again(pattern);
  ASSERT_EQ(again.pieces.size(), 3u);
  EXPECT_EQ(again.pieces[1].name, "front:2");
  EXPECT_GT(signed_area(again.pieces[1]), 0);
  EXPECT_NEAR(signed_area(again.pieces[1]), signed_area(front), 1e-12);
  EXPECT_EQ(again.pieces[2].outline.size(), 5u);
  ASSERT_EQ(again.seams.size(), 3u);
  for (std::size_t s = 0; s < 3; ++s) {
    EXPECT_NEAR(span_length(again, again.seams[s].a), span_length(pattern, pattern.seams[s].a), 1e-9);
    EXPECT_NEAR(span_length(again, again.seams[s].b), span_length(pattern, pattern.seams[s].b), 1e-9);
    EXPECT_FALSE(again.seams[s].right_to_wrong) << s;
  }
  const auto said = [&, &report = losses](const std::string& code) {
    return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) { return f.code == code; });
  };
  EXPECT_TRUE(said("garmentcode.copies"));
  EXPECT_TRUE(said("garmentcode.edges-split"));
  EXPECT_TRUE(said("garmentcode.no-placement"));
  EXPECT_TRUE(said("garmentcode.no-seam-name"));
}

TEST(WriteGarmentCode, ReadsRealPatternsBackIdentically) {
  const char* corpus = std::getenv("TOILE_CORPUS");
  if (!corpus) GTEST_SKIP() << "TOILE_CORPUS is not set";
  int files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(std::filesystem::path(corpus) / "patterns/garmentcode")) {
    if (entry.path().extension() != ".json") continue;
    const auto read = read_garmentcode(entry.path());
    ASSERT_TRUE(read.value) << entry.path();
    SCOPED_TRACE(entry.path().filename().string());
    expect_same(*read.value, read_again(*read.value), 1e-6);
    ++files;
  }
  EXPECT_GT(files, 5);
}

TEST(ReadGarmentCode, SaysWhatItLeavesAsideAndTakesPartialFiles) {
  const std::string text = R"({"pattern": {"panels": {"a": {"vertices": [[0,0],[10,0],[0,10]], "pocket": 1,
    "edges": [{"endpoints":[0,1]},{"endpoints":[1,2],"curvature":[0.5,0.1]},{"endpoints":[2,0]}]}}}, "made_by": "x"})";
  const auto ambiguous = read_garmentcode_text(text, "a.json");
  ASSERT_FALSE(ambiguous.value);
  EXPECT_EQ(ambiguous.report.findings.back().fault, Fault::ambiguous);
  const auto read = read_garmentcode_text(text, "a.json", 1 / 300.);
  ASSERT_TRUE(read.value);
  EXPECT_EQ(read.value->units.decided_by, "override");
  EXPECT_TRUE(read.value->pattern.pieces[0].placement.empty());
  EXPECT_GT(read.value->pattern.pieces[0].outline[1].points.size(), 2u);
  std::string codes;
  for (const Finding& finding : read.report.findings) codes += finding.code + " " + finding.text + "\n";
  EXPECT_NE(codes.find("garmentcode.no-placement"), std::string::npos);
  EXPECT_NE(codes.find("garmentcode.no-stitches"), std::string::npos);
  EXPECT_NE(codes.find("made_by, panel.pocket"), std::string::npos) << codes;
}

}  // namespace
}  // namespace toile
