#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "formats/dxf_aama/turn_points.h"
#include "formats/dxf_text.h"

namespace toile {
namespace {

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

// A replica's outline may have a curve point a few micrometres beside a corner.
TEST(TurnPoints, StayWhereACurvePointLiesBesideThem) {
  const Xy ring{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 4e-6}};
  aama::DrawnPiece piece;
  piece.points.push_back({ring[4], false});
  for (std::size_t i = 0; i < 4; ++i) piece.points.push_back({ring[i], true});
  const aama::TurnPoints found = aama::turn_points(ring, piece, {});
  EXPECT_EQ(found.turn, (std::vector<bool>{true, true, true, true, false}));
  EXPECT_FALSE(found.by_angle);
}

}  // namespace
}  // namespace toile
