// The sample skirt by numbers a pattern maker would check with a tape.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "formats/formats.h"
#include "garment/units.h"

namespace toile {
namespace {

Pattern skirt() {
  const auto loaded = read_pattern(std::filesystem::path(TOILE_SOURCE_DIR) / "samples/gored_skirt/gored_skirt.dxf");
  for (const Finding& f : loaded.report.findings) EXPECT_EQ(f.severity, Severity::note) << in_words(f);
  return loaded.value.value();
}

double width_at(const Piece& piece, double height) {
  double low = 1, high = -1;
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Eigen::Vector2d &a = edge.points[i - 1].at, &b = edge.points[i].at;
      if ((a.y() - height) * (b.y() - height) > 0 || a.y() == b.y()) continue;
      const double x = a.x() + (b.x() - a.x()) * (height - a.y()) / (b.y() - a.y());
      low = std::min(low, x);
      high = std::max(high, x);
    }
  return high - low;
}

TEST(GoredSkirt, MeasuresWhatItsDraftSays) {
  const Pattern pattern = skirt();
  EXPECT_EQ(pattern.sample_size, "38");
  const Piece &gore = *find_piece(pattern, "GORE"), &band = *find_piece(pattern, "WAISTBAND");
  EXPECT_EQ(copies(gore), 8);
  EXPECT_NEAR(length(*find_edge(band, "bottom")), 70.5_cm, .1_mm);
  EXPECT_NEAR(8 * length(*find_edge(gore, "top")), 70.5_cm, .1_mm);
  EXPECT_NEAR(8 * width_at(gore, 0), 100.0_cm, .1_mm);  // the hip line is drawn at y = 0
  EXPECT_NEAR(8 * (find_edge(gore, "hem")->points.back().at - find_edge(gore, "hem")->points.front().at).norm(), 140.0_cm,
              .1_mm);
  EXPECT_NEAR(length(*find_edge(gore, "right")), length(*find_edge(gore, "left")), 1e-6);
}

TEST(GoredSkirt, GoresAreSymmetricSquareAtTheirCornersAndSmooth) {
  const Pattern pattern = skirt();
  const Piece& gore = *find_piece(pattern, "GORE");
  const Edge &right = *find_edge(gore, "right"), &left = *find_edge(gore, "left");
  ASSERT_EQ(right.points.size(), left.points.size());
  for (std::size_t k = 0; k < right.points.size(); ++k) {
    const Eigen::Vector2d& other = left.points[left.points.size() - 1 - k].at;
    EXPECT_NEAR(right.points[k].at.x(), -other.x(), 1e-6);
    EXPECT_NEAR(right.points[k].at.y(), other.y(), 1e-6);
  }
  for (std::size_t e = 0; e < 4; ++e) {
    const auto &in = gore.outline[e].points, &out = gore.outline[(e + 1) % 4].points;
    const Eigen::Vector2d a = (in.back().at - in[in.size() - 2].at).normalized(), b = (out[1].at - out[0].at).normalized();
    EXPECT_NEAR(std::acos(a.dot(b)) / units::degree, 90, 3) << gore.outline[e].id;
    for (std::size_t k = 2; k < in.size(); ++k) {
      const Eigen::Vector2d d = (in[k - 1].at - in[k - 2].at).normalized(), f = (in[k].at - in[k - 1].at).normalized();
      EXPECT_LT(std::acos(std::min(d.dot(f), 1.0)) / units::degree, 2.5) << gore.outline[e].id << " " << k;
    }
  }
}

TEST(GoredSkirt, HasAllowancesNotchesAndGrain) {
  const Pattern pattern = skirt();
  const Piece &gore = *find_piece(pattern, "GORE"), &band = *find_piece(pattern, "WAISTBAND");
  EXPECT_TRUE(find_edge(gore, "hem")->hem);
  EXPECT_NEAR(find_edge(gore, "hem")->seam_allowance.value_or(0), 3.0_cm, .1_mm);
  EXPECT_NEAR(find_edge(gore, "right")->seam_allowance.value_or(0), 1.0_cm, .1_mm);
  ASSERT_EQ(gore.notches.size(), 2u);
  EXPECT_NEAR(gore.notches[0].at + gore.notches[1].at, 1, 1e-3);  // the hip notches meet when the gores are sewn
  EXPECT_EQ(band.notches.size(), 3u);
  ASSERT_TRUE(gore.grainline && band.grainline);
  EXPECT_NEAR(gore.grainline->from.x(), gore.grainline->to.x(), 1e-6);
  EXPECT_NEAR(band.grainline->from.y(), band.grainline->to.y(), 1e-6);
}

TEST(GoredSkirt, EverySeamIsEvenAndEveryEdgeButTheHemAndTheTopOfTheBandIsSewn) {
  const Pattern pattern = skirt();
  ASSERT_EQ(pattern.seams.size(), 17u);
  double sewn = 0, edges = 0;
  for (const Seam& seam : pattern.seams) {
    EXPECT_NEAR(span_length(pattern, seam.a), span_length(pattern, seam.b), .1_mm) << seam.name;
    sewn += span_length(pattern, seam.a) + span_length(pattern, seam.b);
  }
  for (const Piece& piece : pattern.pieces)
    for (const Edge& edge : piece.outline)
      if (edge.id != "hem" && !(piece.name == "WAISTBAND" && edge.id == "top")) edges += copies(piece) * length(edge);
  EXPECT_NEAR(sewn, edges, .2_mm);
}

TEST(GoredSkirt, GoresSitRoundTheBodyInTheOrderInWhichTheyAreSewnToTheBand) {
  const Pattern pattern = skirt();
  const Piece& gore = *find_piece(pattern, "GORE");
  const double middle_of_band = find_piece(pattern, "WAISTBAND")->body_part.at(0)->angle;
  for (const Seam& seam : pattern.seams) {
    if (seam.a.piece != "WAISTBAND" || seam.b.piece != "GORE") continue;
    const double along = (seam.a.begin + seam.a.end) / 2;  // of the band, which goes once round
    const double angle = middle_of_band + (along - .5) * 2 * std::numbers::pi;
    const double sits = gore.body_part.at(static_cast<std::size_t>(seam.b.copy - 1))->angle;
    EXPECT_NEAR(std::remainder(angle - sits, 2 * std::numbers::pi), 0, 1e-6) << seam.name;
  }
}

}  // namespace
}  // namespace toile
