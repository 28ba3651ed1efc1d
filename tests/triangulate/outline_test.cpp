#include "triangulate/outline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "triangulate/expect_code.h"
#include "triangulate/sample_patterns.h"

namespace toile {
namespace {

using Loop = std::vector<Eigen::Vector2d>;

Pattern only(Piece piece) {
  Pattern pattern;
  pattern.pieces = {std::move(piece)};
  return pattern;
}

TEST(CheckOutlines, AcceptsSimpleCounterClockwiseLoops) {
  EXPECT_NO_THROW(check_outlines(gored_skirt()));
  EXPECT_NO_THROW(check_outlines(darted_panel()));
}

TEST(CheckOutlines, NamesThePieceTheEdgesAndThePlaceOfACrossing) {
  const Finding finding = refusal([] { check_outlines(only(polygon_piece("cuff", {{0, 0}, {.1, .1}, {.1, 0}, {0, .1}}))); });
  EXPECT_EQ(finding.code, "pattern.self-crossing");
  EXPECT_EQ(finding.place, "piece 'cuff'");
  EXPECT_NE(finding.text.find("'e0'"), std::string::npos);
  EXPECT_NE(finding.text.find("'e2'"), std::string::npos);
}

TEST(CheckOutlines, RefusesOpenOutlinesWithTheGap) {
  Piece piece = rectangle("cuff", .2, .1);
  piece.outline[2].points.back().at.y() += .004;
  const Finding finding = refusal([&] { check_outlines(only(piece)); });
  EXPECT_EQ(finding.code, "pattern.open-outline");
  EXPECT_NE(finding.text.find("4.0 mm"), std::string::npos);
  EXPECT_NE(finding.text.find("'top'"), std::string::npos);
}

TEST(CheckOutlines, RefusesWhatIsNoOutline) {
  EXPECT_EQ(refusal([] { check_outlines(only(Piece{})); }).code, "pattern.no-outline");
  Piece turned = polygon_piece("cuff", {{0, 0}, {0, .1}, {.2, .1}, {.2, 0}});
  EXPECT_EQ(refusal([&] { check_outlines(only(turned)); }).code, "pattern.clockwise-outline");
  Piece nan = rectangle("cuff", .2, .1);
  nan.outline[1].points[0].at.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([&] { check_outlines(only(nan)); }).code, "pattern.not-finite");
  Piece point = rectangle("cuff", .2, .1);
  point.outline.push_back(straight_edge("nothing", {0, 0}, {0, 0}));
  EXPECT_EQ(refusal([&] { check_outlines(only(point)); }).code, "pattern.edge-without-length");
}

TEST(CheckOutlines, PassesOverPointsGivenTwice) {
  Piece piece = rectangle("cuff", .2, .1);
  auto& points = piece.outline[0].points;
  points.insert(points.begin() + 1, {{.1, 0}, false, {}});
  points.insert(points.begin() + 1, points[1]);
  points.push_back(points.back());
  EXPECT_NO_THROW(check_outlines(only(piece)));
}

}  // namespace
}  // namespace toile
