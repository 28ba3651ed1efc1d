#include <gtest/gtest.h>

#include <numbers>

#include "pieces.h"

namespace toile {
namespace {

using namespace testing;
using Eigen::Vector2d;

// A skirt panel with a straight hem of 30 mm on the x axis, its sides leaning outwards going down by `flare` radians.
Piece panel(double flare, double side_allowance = .01) {
  const double height = .2, lean = height * std::tan(flare);
  return piece({edge("hem", {{-.15, 0}, {.15, 0}}), edge("right", {{.15, 0}, {.15 - lean, height}}, side_allowance),
                edge("waist", {{.15 - lean, height}, {-.15 + lean, height}}),
                edge("left", {{-.15 + lean, height}, {-.15, 0}}, side_allowance)});
}

// Points of the cut line below the hem line, turned up about it.
Points turned_up(const CutPiece& cut) {
  Points points;
  for (const OutlinePoint& point : cut.cut_line)
    if (point.at.y() < 1e-9) points.emplace_back(point.at.x(), -point.at.y());
  return points;
}

class HemCorner : public ::testing::TestWithParam<int> {};

TEST_P(HemCorner, TurnedUpEndsOnTheSideCutLines) {
  const double flare = GetParam() * std::numbers::pi / 180;
  const CutPiece cut = add_allowance(panel(flare));
  const Points points = turned_up(cut);
  ASSERT_EQ(points.size(), 4u);
  const Vector2d along(-std::sin(flare), std::cos(flare));  // of the right side, upwards
  for (const Vector2d& p : points) {
    const Vector2d right(std::abs(p.x()), p.y());
    EXPECT_NEAR(std::abs(cross(right - Vector2d(.15, 0), along)), .01, 1e-12) << p.transpose();
    EXPECT_TRUE(std::abs(p.y()) < 1e-12 || std::abs(p.y() - .03) < 1e-12);
  }
  EXPECT_EQ(cut.cut_line.size(), 6u);
}

INSTANTIATE_TEST_SUITE_P(FromTaperedToFlared, HemCorner, ::testing::Values(-25, -10, 0, 4, 10, 20, 35));

TEST(HemCorner, FollowsACurvedSide) {
  Points side;
  for (int i = 0; i <= 40; ++i) {
    const double y = .4 * i / 40;
    side.emplace_back(.15 - .1 * std::sqrt(y * .4) - .2 * y * y, y);
  }
  Points left;
  for (auto p = side.rbegin(); p != side.rend(); ++p) left.emplace_back(-p->x(), p->y());
  const Piece curved = piece({edge("hem", {left.back(), side.front()}), edge("right", side),
                              edge("waist", {side.back(), left.front()}), edge("left", left)});
  const CutPiece cut = add_allowance(curved);
  const Points points = turned_up(cut);
  EXPECT_GT(points.size(), 6u);  // the curve's points are reflected too
  Polygon above;
  for (const OutlinePoint& point : cut.cut_line)
    if (point.at.y() > -1e-9) above.push_back(point.at);
  for (const Vector2d& p : points) EXPECT_LT(distance_to(above, p), 1e-9) << p.transpose();
}

TEST(HemCorner, FoldsGoStraightThroughASquareHem) {
  const CutPiece cut = add_allowance(panel(0, 0));
  for (const OutlinePoint& point : cut.cut_line) EXPECT_NEAR(std::abs(point.at.x()), .15, 1e-12);
}

TEST(HemCorner, TakesTheHemMarkedOnTheEdge) {
  Piece marked = panel(0);
  marked.outline[0].id = "bottom";
  marked.outline[0].hem = true;
  double low = 0;
  for (const OutlinePoint& point : add_allowance(marked).cut_line) low = std::min(low, point.at.y());
  EXPECT_DOUBLE_EQ(low, -.03);
  marked.outline[0].hem = false;
  low = 0;
  for (const OutlinePoint& point : add_allowance(marked).cut_line) low = std::min(low, point.at.y());
  EXPECT_DOUBLE_EQ(low, -.01);
}

TEST(HemCorner, IsMitredWhenAskedOrWhenTheSideIsTooShortToMirror) {
  AllowanceRules rules;
  rules.hem_corner = Corner::mitre;
  EXPECT_EQ(add_allowance(panel(.2), rules).cut_line.size(), 4u);
  const Piece strip = piece({edge("hem", {{0, 0}, {.2, 0}}), edge("right", {{.2, 0}, {.2, .015}}),
                             edge("top", {{.2, .015}, {0, .015}}), edge("left", {{0, .015}, {0, 0}})});
  EXPECT_EQ(add_allowance(strip).cut_line.size(), 4u);
}

}  // namespace
}  // namespace toile
