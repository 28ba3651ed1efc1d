#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "pieces.h"

namespace toile {
namespace {

using namespace testing;
using Eigen::Vector2d;

Notch notch(const std::string& edge, double at) {
  Notch made;
  made.edge = edge;
  made.at = at;
  return made;
}

TEST(CutNotch, MovesOutToTheCutLineSquareToTheSeam) {
  Piece square = rectangle(.4, .3, {.02, .01, .01, .01});
  square.notches = {notch("e0", .25), notch("e1", .5)};
  const CutPiece cut = add_allowance(square);
  ASSERT_EQ(cut.notches.size(), 2u);
  EXPECT_NEAR((cut.notches[0].at - Vector2d(.1, -.02)).norm(), 0, 1e-12);
  EXPECT_NEAR((cut.notches[0].direction - Vector2d(0, 1)).norm(), 0, 1e-12);
  EXPECT_NEAR((cut.notches[1].at - Vector2d(.41, .15)).norm(), 0, 1e-12);
  EXPECT_NEAR((cut.notches[1].direction - Vector2d(-1, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(cut.notches[0].notch, square.notches[0]);
}

TEST(CutNotch, OnACurveLiesOnTheRadius) {
  const Points round = arc({0, 0}, .2, 0, std::numbers::pi / 2, 24);
  Piece quarter = piece({edge("round", round), edge("left", {round.back(), {0, 0}}), edge("low", {{0, 0}, round.front()})});
  for (const double at : {.1, .5, .77}) quarter.notches.push_back(notch("round", at));
  for (const CutNotch& moved : add_allowance(quarter).notches) {
    const double angle = moved.notch.at * std::numbers::pi / 2;
    EXPECT_NEAR(std::atan2(moved.at.y(), moved.at.x()), angle, .004);
    EXPECT_GT(moved.direction.dot(-moved.at.normalized()), .999);
  }
}

TEST(CutNotch, AsManyAsBeforeAtEndsCornersAndFolds) {
  Piece square = rectangle(.4, .3, {.01, .01, .01, 0});
  for (const char* id : {"e0", "e1", "e2", "e3"})
    for (const double at : {0., .5, 1.}) square.notches.push_back(notch(id, at));
  const CutPiece cut = add_allowance(square);
  ASSERT_EQ(cut.notches.size(), square.notches.size());
  const Polygon line = places(cut.cut_line);
  for (const CutNotch& moved : cut.notches) {
    EXPECT_LT(distance_to(line, moved.at), 1e-9);
    EXPECT_NEAR(moved.direction.norm(), 1, 1e-12);
  }
}

TEST(CutNotch, StaysClearOfTheSeam) {
  Piece square = rectangle(.4, .3, {.003, .01, .01, 0});
  square.notches = {notch("e0", .5), notch("e1", .5), notch("e3", .5)};
  const CutPiece cut = add_allowance(square);
  EXPECT_NEAR(cut.notches[0].notch.depth, .0024, 1e-12);
  EXPECT_EQ(cut.notches[1].notch.depth, .004);
  EXPECT_EQ(cut.notches[2].notch.depth, 0);  // a mark on the fold
}

TEST(CutNotch, OnAnUnknownEdgeIsABrokenPrecondition) {
  Piece square = rectangle(.4, .3);
  square.notches = {notch("elsewhere", .5)};
  EXPECT_THROW(add_allowance(square), std::invalid_argument);
}

bool has(const CutPiece& cut, const std::string& words) {
  return std::any_of(cut.labels.begin(), cut.labels.end(),
                     [&](const std::string& label) { return label.find(words) != std::string::npos; });
}

TEST(Labels, SayHowManyToCut) {
  Piece square = rectangle(.4, .3);
  square.quantity = 8;
  EXPECT_TRUE(has(add_allowance(square), "Cut 8"));
  square.quantity = square.mirrored_quantity = 1;
  EXPECT_TRUE(has(add_allowance(square), "Cut 1 pair (2 mirrored)"));
  square.quantity = square.mirrored_quantity = 2;
  EXPECT_TRUE(has(add_allowance(square), "Cut 2 pairs (4 mirrored)"));
  square.quantity = 2, square.mirrored_quantity = 1;
  EXPECT_TRUE(has(add_allowance(square), "Cut 3 (1 mirrored)"));
}

TEST(Labels, StateEveryAllowanceInBothUnits) {
  Piece square = rectangle(.4, .3, {.0127, .01, .01, 0});
  square.outline[0].hem = true;
  square.material = "self";
  const CutPiece cut = add_allowance(square);
  EXPECT_EQ(cut.labels.front(), "piece");
  EXPECT_TRUE(has(cut, "Allowance included: 10 mm (0.39 in)"));
  EXPECT_TRUE(has(cut, "hem e0: 12.7 mm (0.5 in)"));
  EXPECT_TRUE(has(cut, "e3: none"));
  EXPECT_TRUE(has(cut, "Material: self"));
}

}  // namespace
}  // namespace toile
