#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polyline.h"
#include "triangulate/expect_code.h"
#include "triangulate/intervals.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/sampling.h"
#include "triangulate/seam_places.h"

namespace toile {
namespace {

constexpr double h = 15e-3;

std::vector<double> fractions(const std::vector<OutlineSample>& samples, int edge) {
  std::vector<double> at;
  for (const OutlineSample& sample : samples)
    if (sample.edge == edge) at.push_back(sample.at);
  at.push_back(1);
  return at;
}

Pattern two_strips(double a, double b) {
  Pattern pattern;
  pattern.pieces = {rectangle("a", a, .05), rectangle("b", b, .05)};
  pattern.seams = {{"join", span("a", 1, "bottom"), span("b", 1, "top", 1, 0), false}};
  return pattern;
}

TEST(SeamPlaces, LookUpNames) {
  const auto places = seam_places(gored_skirt());
  ASSERT_EQ(places.size(), 17u);
  EXPECT_EQ(places[0].a.piece, 0);
  EXPECT_EQ(places[0].a.edge, 1);
  EXPECT_EQ(places[0].b.copy, 2);
  EXPECT_EQ(places[1].a.piece, 1);
  EXPECT_DOUBLE_EQ(places[1].a.end, .125);
}

TEST(SeamPlaces, NameWhatIsUnknownAndListWhatThereIs) {
  Pattern pattern = two_strips(.3, .3);
  pattern.seams[0].a.edge = "botom";
  Finding finding = refusal([&] { seam_places(pattern); });
  EXPECT_EQ(finding.code, "seam.unknown-edge");
  EXPECT_EQ(finding.remedy, "Its edges are 'bottom', 'right', 'top', 'left'");
  EXPECT_EQ(finding.place, "seam 'join' (a:1 botom to b:1 top)");
  pattern = two_strips(.3, .3);
  pattern.seams[0].b.piece = "c";
  finding = refusal([&] { seam_places(pattern); });
  EXPECT_EQ(finding.code, "seam.unknown-piece");
  EXPECT_EQ(finding.remedy, "The pattern has 'a', 'b'");
  pattern = two_strips(.3, .3);
  pattern.seams[0].b.copy = 2;
  EXPECT_EQ(refusal([&] { seam_places(pattern); }).code, "seam.unknown-copy");
}

TEST(SeamPlaces, RefuseSpansThatLeaveTheEdgeOrVanish) {
  Pattern pattern = two_strips(.3, .3);
  pattern.seams[0].a.end = 1.2;
  EXPECT_EQ(refusal([&] { seam_places(pattern); }).code, "seam.span-outside-edge");
  pattern.seams[0].a.end = .001;
  EXPECT_EQ(refusal([&] { seam_places(pattern); }).code, "seam.span-too-short");
  pattern.seams[0].a.end = std::nan("");
  EXPECT_EQ(refusal([&] { seam_places(pattern); }).code, "seam.span-outside-edge");
}

TEST(SeamPlaces, TakeAnEdgeSewnToSeveral) {
  Pattern pattern = two_strips(.3, .3);
  pattern.pieces.push_back(rectangle("c", .3, .05));
  pattern.seams.push_back({"again", span("c", 1, "top", 1, 0), span("a", 1, "bottom", .4, .6), false});
  EXPECT_EQ(seam_places(pattern).size(), 2u);
}

TEST(SeamPlaces, RefuseTwoRunsSewnToEachOtherTwice) {
  Pattern pattern = two_strips(.3, .3);
  const Seam join = pattern.seams[0];
  for (const bool exchanged : {false, true}) {
    pattern.seams.resize(1);
    Seam again{"again", exchanged ? join.b : join.a, exchanged ? join.a : join.b, false};
    pattern.seams.push_back(again);
    const Finding finding = refusal([&] { seam_places(pattern); });
    EXPECT_EQ(finding.code, "seam.overlap");
    EXPECT_NE(finding.text.find("seam 'join'"), std::string::npos);
    EXPECT_FALSE(finding.remedy.empty());
  }
  pattern.seams = {{"fold", span("a", 1, "bottom", 0, .6), span("a", 1, "bottom", 1, .5), false}};
  EXPECT_EQ(refusal([&] { seam_places(pattern); }).code, "seam.overlap");
}

TEST(SeamPlaces, MakeEndsWithinHalfAMillimetreAgree) {
  Pattern pattern;
  pattern.pieces = {rectangle("band", .6, .05), rectangle("a", .2, .1), rectangle("b", .4, .1)};
  pattern.seams = {{"1", span("band", 1, "bottom", 0, .3333), span("a", 1, "top", 1, 0), false},
                   {"2", span("band", 1, "bottom", .3329, .9999), span("b", 1, "top", 1, 0), false}};
  const auto places = seam_places(pattern);
  EXPECT_EQ(places[0].a.end, places[1].a.begin);
  EXPECT_EQ(places[1].a.end, 1);
}

TEST(Intervals, CarryMarksThroughCopies) {
  // The mark on a's top comes from the short strip; copies carry it to b, which never meets that strip.
  Pattern pattern;
  Piece a = rectangle("a", .3, .1);
  a.quantity = 2;
  pattern.pieces = {a, rectangle("b", .3, .1), rectangle("short", .12, .1)};
  pattern.seams = {{"1", span("a", 1, "top"), span("b", 1, "bottom", 1, 0), false},
                   {"2", span("a", 2, "top", 0, .4), span("short", 1, "bottom", 1, 0), false}};
  std::vector<double> on_b;
  for (const Interval& part : intervals(pattern, seam_places(pattern)))
    if (part.piece == 1 && part.edge == 0) on_b.push_back(part.begin);
  ASSERT_EQ(on_b.size(), 2u);
  EXPECT_NEAR(on_b[1], .6, 1e-12);
}

TEST(Intervals, KeepACornerInsideAnEdge) {
  Pattern pattern;
  Piece piece = rectangle("a", .3, .1);
  piece.outline[0].points.insert(piece.outline[0].points.begin() + 1, {{.1, -.1}, false, {}});
  pattern.pieces = {piece};
  const auto samples = sample_outlines(pattern, h)[0];
  EXPECT_TRUE(std::any_of(samples.begin(), samples.end(),
                          [](const OutlineSample& s) { return (s.position - Eigen::Vector2d(.1, -.1)).norm() < 1e-12; }));
}

TEST(Intervals, RefuseAnEdgeDividedWithoutEnd) {
  Pattern pattern;
  Piece piece = rectangle("a", .3, .3);
  piece.quantity = 2;
  pattern.pieces = {piece};
  pattern.seams = {{"1", span("a", 1, "right", .2, 1), span("a", 2, "right", 1, 0), false}};
  EXPECT_EQ(refusal([&] { intervals(pattern, seam_places(pattern)); }).code, "seam.ends-nearly-meet");
}

TEST(SampleOutlines, DivideSeamsByTheMeanOfTheirLengths) {
  const auto samples = sample_outlines(two_strips(.30, .36), h);
  const auto a = fractions(samples[0], 0), b = fractions(samples[1], 2);
  EXPECT_EQ(a.size() - 1, static_cast<std::size_t>(std::lround(std::sqrt(.30 * .36) / h)));
  EXPECT_EQ(a, b);
}

TEST(SampleOutlines, DivideGathersByTheLongerSide) {
  const auto samples = sample_outlines(two_strips(.30, .60), h);
  EXPECT_EQ(fractions(samples[0], 0).size(), 41u);
  EXPECT_EQ(fractions(samples[1], 2).size(), 41u);
}

TEST(SampleOutlines, MateFractionsAlongPartialSpans) {
  const Pattern skirt = gored_skirt();
  const auto samples = sample_outlines(skirt, h);
  const auto waist = fractions(samples[0], 2), band = fractions(samples[1], 0);
  const std::size_t n = waist.size() - 1;
  ASSERT_EQ(band.size(), 8 * n + 1);
  for (std::size_t gore = 0; gore < 8; ++gore)
    for (std::size_t i = 0; i <= n; ++i)  // the waist runs against the band
      EXPECT_NEAR(band[gore * n + i] * 8 - static_cast<double>(gore), 1 - waist[n - i], 1e-12);
}

TEST(SampleOutlines, LieOnTheOutlineAtTheirFraction) {
  const Pattern pattern = mirrored_fronts();
  const auto samples = sample_outlines(pattern, h);
  for (const OutlineSample& s : samples[0]) {
    const Edge& edge = pattern.pieces[0].outline[static_cast<std::size_t>(s.edge)];
    EXPECT_LT(nearest_on<2>(positions(edge), s.position).distance, 1e-12);
    EXPECT_LT((point_at<2>(positions(edge), s.at) - s.position).norm(), 1e-12);
  }
}

TEST(SampleOutlines, KeepTheLengthOfCurves) {
  const Pattern pattern = mirrored_fronts();
  const auto samples = sample_outlines(pattern, h)[0];
  for (const int edge : {2, 4}) {
    double chords = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (samples[i].edge == edge) chords += (samples[(i + 1) % samples.size()].position - samples[i].position).norm();
    const double exact = length(pattern.pieces[0].outline[static_cast<std::size_t>(edge)]);
    EXPECT_LE(exact - chords, std::max(1e-3 * exact, 2e-4));
    EXPECT_GE(exact, chords);
  }
}

TEST(SampleOutlines, AreFinerWhereChordsWouldCross) {
  // A crescent 2 mm wide: at 15 mm its chords would cut through each other.
  Pattern pattern;
  Piece piece;
  piece.name = "crescent";
  piece.outline = {arc_edge("outer", {-.05, 0}, {.05, 0}, {0, .03}), arc_edge("inner", {.05, 0}, {-.05, 0}, {0, .0325})};
  pattern.pieces = {piece};
  ASSERT_FALSE(signed_area(piece) <= 0);
  const auto samples = sample_outlines(pattern, .06)[0];
  double twice_area = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Eigen::Vector2d &a = samples[i].position, &b = samples[(i + 1) % samples.size()].position;
    twice_area += a.x() * b.y() - a.y() * b.x();
  }
  EXPECT_GT(twice_area, 0);
}

// A band with a strip over its whole lower edge and shorter ones on top of it.
Pattern layered_strips() {
  Pattern pattern;
  pattern.pieces = {rectangle("band", .6, .05), rectangle("skirt", .6, .2), rectangle("over", .6, .1),
                    rectangle("flap", .2, .1)};
  pattern.seams = {{"1", span("band", 1, "bottom"), span("skirt", 1, "top", 1, 0), false},
                   {"2", span("band", 1, "bottom"), span("over", 1, "top", 1, 0), false},
                   {"3", span("band", 1, "bottom", .21, .54), span("flap", 1, "top", 1, 0), false}};
  return pattern;
}

TEST(SampleOutlines, DivideAllEdgesOfOneSeamAlike) {
  const auto samples = sample_outlines(layered_strips(), 15e-3);
  const auto at = [&](std::size_t piece, int edge) {
    std::vector<double> places;
    for (const OutlineSample& sample : samples[piece])
      if (sample.edge == edge) places.push_back(edge == 2 ? 1 - sample.at : sample.at);
    std::sort(places.begin(), places.end());
    return places;
  };
  auto band = at(0, 0);
  band.push_back(1);
  for (const std::size_t piece : {1u, 2u}) {
    auto hung = at(piece, 2);
    hung.insert(hung.begin(), 0);
    ASSERT_EQ(hung.size(), band.size());
    for (std::size_t i = 0; i < band.size(); ++i) EXPECT_NEAR(hung[i], band[i], 1e-12);
  }
  // The ends of the flap are marks on all of them.
  for (const double end : {.21, .54})
    EXPECT_TRUE(std::any_of(band.begin(), band.end(), [&](double b) { return std::abs(b - end) < 1e-12; }));
  auto flap = at(3, 2);
  flap.insert(flap.begin(), 0);
  const auto inside = std::count_if(band.begin(), band.end(), [](double b) { return b > .21 - 1e-9 && b < .54 + 1e-9; });
  EXPECT_EQ(static_cast<std::ptrdiff_t>(flap.size()), inside);
}

TEST(SampleOutlines, RefuseThreeEdgesThatDoNotCloseUpon) {
  // b and c are each sewn to a from its start, and to each other from opposite ends: every edge would fold onto itself.
  Pattern pattern;
  pattern.pieces = {rectangle("a", .3, .1), rectangle("b", .3, .1), rectangle("c", .3, .1)};
  pattern.seams = {{"1", span("a", 1, "top"), span("b", 1, "bottom", 1, 0), false},
                   {"2", span("a", 1, "top"), span("c", 1, "bottom", 1, 0), false},
                   {"3", span("b", 1, "bottom"), span("c", 1, "bottom", 1, 0), false}};
  EXPECT_EQ(refusal([&] { sample_outlines(pattern, 15e-3); }).code, "seam.not-manifold");
  // The right way round it only says again what the first two say.
  pattern.seams[2] = {"3", span("b", 1, "bottom"), span("c", 1, "bottom"), true};
  EXPECT_NO_THROW(sample_outlines(pattern, 15e-3));
}

}  // namespace
}  // namespace toile
