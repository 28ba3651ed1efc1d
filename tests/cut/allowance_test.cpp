#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "cut/cut.h"
#include "pieces.h"

namespace toile {
namespace {

using namespace testing;
using Eigen::Vector2d;

constexpr double pi = std::numbers::pi;

// The cut line has exactly these corners, in this order from any of them, all turn points.
void expect_corners(const CutPiece& cut, const Points& corners) {
  ASSERT_EQ(cut.cut_line.size(), corners.size());
  std::size_t start = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    if ((cut.cut_line[i].at - corners[0]).norm() < (cut.cut_line[start].at - corners[0]).norm()) start = i;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const OutlinePoint& point = cut.cut_line[(start + i) % corners.size()];
    EXPECT_NEAR((point.at - corners[i]).norm(), 0, 1e-12) << "corner " << i << ": " << point.at.transpose();
    EXPECT_TRUE(point.turn);
  }
}

AllowanceRules with_corner(Corner corner) {
  AllowanceRules rules;
  rules.corner = corner;
  return rules;
}

TEST(Allowance, GrowsASquareByItsAllowance) {
  expect_corners(add_allowance(rectangle(.4, .4)), {{-.01, -.01}, {.41, -.01}, {.41, .41}, {-.01, .41}});
}

TEST(Allowance, TakesEachEdgeByItsOwnWidth) {
  expect_corners(add_allowance(rectangle(.4, .3, {.04, .015, .006, .01})),
                 {{-.01, -.04}, {.415, -.04}, {.415, .306}, {-.01, .306}});
}

TEST(Allowance, LeavesFoldEdgesWhereTheyAre) {
  expect_corners(add_allowance(rectangle(.4, .3, {.03, .01, .01, 0})), {{0, -.03}, {.41, -.03}, {.41, .31}, {0, .31}});
}

TEST(Allowance, EndsOnTheContinuationOfASlantingFold) {
  const CutPiece cut = add_allowance(polygon_piece({{0, 0}, {.4, 0}, {.4, .3}, {.03, .3}}, {.02, .01, .01, 0}));
  const Vector2d fold = Vector2d(.03, .3).normalized();
  expect_corners(cut, {-.02 / fold.y() * fold, {.41, -.02}, {.41, .31}, Vector2d(.03, .3) + .01 / fold.y() * fold});
}

TEST(Allowance, OfNothingIsTheNetLine) {
  expect_corners(add_allowance(rectangle(.4, .3, {0})), {{0, 0}, {.4, 0}, {.4, .3}, {0, .3}});
}

TEST(Allowance, MitresATriangle) {
  const double side = .3, w = .01;
  const Points corners{{0, 0}, {side, 0}, {side / 2, side * std::sqrt(3) / 2}};
  const CutPiece cut = add_allowance(polygon_piece(corners, {w}));
  const Vector2d middle = (corners[0] + corners[1] + corners[2]) / 3;
  Points grown;
  for (const Vector2d& corner : corners)
    grown.push_back(corner + 2 * w * (corner - middle).normalized());  // 1 / sin 30 degrees
  expect_corners(cut, grown);
}

TEST(Allowance, CutsOffLongTips) {
  // 20 degrees: the mitre would reach 5.76 times the allowance.
  const double half = 10 * pi / 180, w = .01;
  const Points corners{{0, 0}, {.4 * std::cos(half), -.4 * std::sin(half)}, {.4 * std::cos(half), .4 * std::sin(half)}};
  for (const double limit : {2.0, 2.5, 4.0}) {
    AllowanceRules rules;
    rules.mitre_limit = limit;
    const CutPiece cut = add_allowance(polygon_piece(corners, {w}), rules);
    ASSERT_EQ(cut.cut_line.size(), 4u);
    double left = 0;
    int at_left = 0;
    for (const OutlinePoint& point : cut.cut_line) left = std::min(left, point.at.x());
    for (const OutlinePoint& point : cut.cut_line) at_left += point.at.x() < left + 1e-12;
    EXPECT_NEAR(left, -limit * w, 1e-12);
    EXPECT_EQ(at_left, 2);
  }
}

TEST(Allowance, BevelsEveryCornerWhenAsked) {
  const CutPiece cut = add_allowance(rectangle(.4, .4), with_corner(Corner::bevel));
  ASSERT_EQ(cut.cut_line.size(), 8u);
  for (const OutlinePoint& point : cut.cut_line) {
    const Vector2d corner(point.at.x() < .2 ? 0 : .4, point.at.y() < .2 ? 0 : .4);
    EXPECT_NEAR((point.at - corner).dot(Vector2d(corner.x() > 0 ? 1 : -1, corner.y() > 0 ? 1 : -1).normalized()), .01, 1e-12);
  }
}

TEST(Allowance, FillsAnInnerCornerCleanly) {
  const Piece ell = polygon_piece({{0, 0}, {.4, 0}, {.4, .2}, {.2, .2}, {.2, .4}, {0, .4}}, {.01, .01, .02, .005, .01, .01});
  expect_corners(add_allowance(ell), {{-.01, -.01}, {.41, -.01}, {.41, .22}, {.205, .22}, {.205, .41}, {-.01, .41}});
}

TEST(Allowance, StepsBetweenWidthsOnOneStraightLine) {
  const Piece side = polygon_piece({{0, 0}, {.2, 0}, {.4, 0}, {.4, .3}, {0, .3}}, {.01, .03, .01, .01, .01});
  expect_corners(add_allowance(side), {{-.01, -.01}, {.2, -.01}, {.2, -.03}, {.41, -.03}, {.41, .31}, {-.01, .31}});
}

TEST(Allowance, StepsAtABluntInnerCornerToo) {
  const double bend = 10 * pi / 180;
  const Vector2d d(std::cos(bend), -std::sin(bend));
  const Vector2d far = Vector2d(.2, 0) + .2 * d;
  const Piece side = polygon_piece({{0, 0}, {.2, 0}, far, {far.x(), .3}, {0, .3}}, {.01, .03, .01, .01, .01});
  const CutPiece cut = add_allowance(side);
  ASSERT_EQ(cut.cut_line.size(), 6u);
  const Vector2d n(-std::sin(bend), -std::cos(bend));
  const Vector2d top = Vector2d(.2, 0) + .03 * n;
  EXPECT_LT(distance_to({top, top + 1e-9 * d, top}, top), 1e-12);
  bool found_top = false, found_foot = false;
  for (const OutlinePoint& point : cut.cut_line) {
    found_top = found_top || (point.at - top).norm() < 1e-12;
    found_foot = found_foot || (point.at - (Vector2d(.2, 0) + .01 / std::cos(bend) * n)).norm() < 1e-12;
  }
  EXPECT_TRUE(found_top);
  EXPECT_TRUE(found_foot);
}

TEST(Allowance, StraightStaysStraightWhereTurnPointsLieOnALine) {
  const Piece side = polygon_piece({{0, 0}, {.1, 0}, {.4, 0}, {.4, .3}, {0, .3}});
  const CutPiece cut = add_allowance(side);
  expect_corners(cut, {{-.01, -.01}, {.1, -.01}, {.41, -.01}, {.41, .31}, {-.01, .31}});
}

TEST(Allowance, KeepsEveryPointOfACurveAndItsFlags) {
  const Points round = arc({0, 0}, .2, 0, pi / 2, 24);
  const CutPiece cut =
      add_allowance(piece({edge("round", round), edge("left", {round.back(), {0, 0}}), edge("low", {{0, 0}, round.front()})}));
  EXPECT_EQ(cut.cut_line.size(), 24u - 1 + 3);
  int turns = 0, on_arc = 0;
  for (const OutlinePoint& point : cut.cut_line) {
    turns += point.turn;
    if (point.turn) continue;
    ++on_arc;
    EXPECT_NEAR(point.at.norm(), .2 + .01 / std::cos(pi / 96), 1e-9);  // between two chords, each .01 away
  }
  EXPECT_EQ(turns, 3);
  EXPECT_EQ(on_arc, 23);
}

TEST(Allowance, KeepsGradeRules) {
  Piece square = rectangle(.4, .4);
  square.outline[1].points.front().grade_rule = 7;
  square.outline[0].points.back().grade_rule = 7;
  const CutPiece cut = add_allowance(square);
  int found = 0;
  for (const OutlinePoint& point : cut.cut_line)
    if (point.grade_rule == 7) {
      ++found;
      EXPECT_NEAR((point.at - Vector2d(.41, -.01)).norm(), 0, 1e-12);
    }
  EXPECT_EQ(found, 1);
}

TEST(Allowance, OfOneClosedEdgeIsRound) {
  Points circle = arc({0, 0}, .1, 0, 2 * pi, 60);
  circle.back() = circle.front();
  const CutPiece cut = add_allowance(piece({edge("brim", circle)}));
  EXPECT_EQ(cut.cut_line.size(), 60u);
  for (const OutlinePoint& point : cut.cut_line) EXPECT_NEAR(point.at.norm(), .1 + .01 / std::cos(pi / 60), 1e-9);
}

TEST(Allowance, TightInnerCurveBecomesTheUnionOfItsStrips) {
  // A round bay of 20 mm radius: its curve has room for 10 mm of allowance and none for 25, the sides have.
  const Piece with_bay =
      piece({edge("low", {{0, 0}, {.2, 0}}), edge("right", {{.2, 0}, {.2, .3}}), edge("top_right", {{.2, .3}, {.15, .3}}),
             edge("slope", {{.15, .3}, {.12, .21}}), edge("bay", arc({.1, .21}, .02, 0, -pi, 16)),
             edge("rise", {{.08, .21}, {.05, .3}}), edge("top_left", {{.05, .3}, {0, .3}}), edge("left", {{0, .3}, {0, 0}})});
  const CutPiece roomy = add_allowance(with_bay);
  EXPECT_FALSE(first_self_crossing(places(roomy.cut_line), touching));
  AllowanceRules wide;
  wide.allowance = .025;
  const CutPiece cut = add_allowance(with_bay, wide);
  const Polygon line = places(cut.cut_line);
  EXPECT_FALSE(first_self_crossing(line, touching));
  EXPECT_GT(signed_area(line), 0);
  for (const Vector2d& p : net_line(with_bay)) EXPECT_GE(distance_to(line, p), .025 - 1e-6);
  for (const OutlinePoint& p : cut.cut_line) EXPECT_NEAR(distance_to(net_line(with_bay), p.at), .025, .0125 + 1e-6);
}

TEST(Allowance, ADartThatIsTooNarrowIsCutStraightAcross) {
  const Piece darted = polygon_piece({{0, 0}, {.3, 0}, {.3, .2}, {.155, .2}, {.15, .1}, {.145, .2}, {0, .2}}, {.01});
  const CutPiece cut = add_allowance(darted);
  const Polygon line = places(cut.cut_line);
  EXPECT_FALSE(first_self_crossing(line, touching));
  for (const Vector2d& p : net_line(darted)) EXPECT_GE(distance_to(line, p), .01 - 1e-6);
  EXPECT_NEAR(signed_area(line), .32 * .22, 1e-9);
}

// Darts as they come: from slits to wide ones, upright and leaning, their legs in one edge or in two that bow in or out.
TEST(Allowance, TakesDartsOfEveryShape) {
  for (const double bow : {0., .003, -.003})
    for (const double lean : {0., .05})
      for (const double mouth : {.004, .01, .02, .06})
        for (const double depth : {.06, .15})
          for (const double width : {.005, .01, .02}) {
            const Vector2d right(.15 + mouth / 2, .4), left(.15 - mouth / 2, .4), point(.15 + lean, .4 - depth);
            const Vector2d out(bow, 0);
            if (mouth / 4 + bow <= 0) continue;  // the legs would cross
            const Piece darted = polygon_piece(
                {{0, 0}, {.3, 0}, {.3, .4}, right, (right + point) / 2 + out, point, (left + point) / 2 - out, left, {0, .4}},
                {width});
            SCOPED_TRACE(std::to_string(mouth) + " wide, " + std::to_string(depth) + " deep, allowance " +
                         std::to_string(width));
            const Polygon line = places(add_allowance(darted).cut_line);
            EXPECT_FALSE(first_self_crossing(line, touching));
            for (const Vector2d& p : net_line(darted)) EXPECT_GE(distance_to(line, p), width - 1e-6);
            // A narrow one is cut straight across its mouth.
            const double whole = (.3 + 2 * width) * (.4 + 2 * width);
            EXPECT_GE(signed_area(line), whole - mouth * depth);
            EXPECT_LE(signed_area(line), whole + 1e-9);
            if (mouth < 1.5 * width && lean == 0) {
              EXPECT_NEAR(signed_area(line), whole, 1e-9);
            }
          }
}

TEST(Allowance, ALeafShapedDartIsNotCutOpen) {
  Piece leaf =
      polygon_piece({{0, 0}, {.3, 0}, {.3, .4}, {.155, .4}, {.18, .25}, {.15, .1}, {.12, .25}, {.145, .4}, {0, .4}}, {.01});
  // Its legs are curved edges, not two each.
  Edge down = edge("down", {{.155, .4}, {.18, .25}, {.15, .1}}), up = edge("up", {{.15, .1}, {.12, .25}, {.145, .4}});
  leaf.outline.erase(leaf.outline.begin() + 3, leaf.outline.begin() + 7);
  leaf.outline.insert(leaf.outline.begin() + 3, {down, up});
  const Polygon line = places(add_allowance(leaf).cut_line);
  EXPECT_NEAR(signed_area(line), .32 * .42, 1e-9);
}

TEST(Allowance, WithoutRoomBetweenTwoArmsIsRefusedWithTheEdge) {
  // The gap between the arms of a U: 12 mm, with 10 mm of allowance on both sides.
  Piece u = polygon_piece({{0, 0}, {.2, 0}, {.2, .3}, {.106, .3}, {.106, .1}, {.094, .1}, {.094, .3}, {0, .3}}, {.01});
  u.name = "yoke";
  try {
    add_allowance(u);
    FAIL() << "cut without an allowance";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "cut.allowance-crosses");
    EXPECT_NE(bad.finding().place.find("yoke"), std::string::npos) << bad.finding().place;
    EXPECT_TRUE(bad.finding().place.find("'e3'") != std::string::npos || bad.finding().place.find("'e5'") != std::string::npos)
        << bad.finding().place;
  }
}

TEST(Allowance, ThatClosesAKeyholeIsRefused) {
  Points hole = arc({.2, .15}, .05, pi / 2 - .1, -3 * pi / 2 + .1, 40);
  const Piece keyhole =
      piece({edge("low", {{0, 0}, {.4, 0}}), edge("right", {{.4, 0}, {.4, .3}}),
             edge("top_right", {{.4, .3}, {hole.front().x(), .3}}), edge("slit_right", {{hole.front().x(), .3}, hole.front()}),
             edge("hole", hole), edge("slit_left", {hole.back(), {hole.back().x(), .3}}),
             edge("top_left", {{hole.back().x(), .3}, {0, .3}}), edge("left", {{0, .3}, {0, 0}})});
  EXPECT_THROW(add_allowance(keyhole), BadInput);
}

TEST(Allowance, OfACrossingOutlineIsRefused) {
  Piece crossing = polygon_piece({{0, 0}, {.4, .02}, {.4, .3}, {.2, -.05}, {0, .3}});
  try {
    add_allowance(crossing);
    FAIL() << "cut a crossing outline";
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "cut.outline-crosses");
  }
}

TEST(Allowance, RefusesWhatIsNoOutline) {
  EXPECT_THROW(add_allowance(polygon_piece({{0, 0}, {0, .3}, {.3, 0}})), std::invalid_argument);  // clockwise
  EXPECT_THROW(add_allowance(rectangle(.1, .1, {-.01})), std::invalid_argument);
  EXPECT_THROW(add_allowance(rectangle(.1, .1, {std::nan("")})), std::invalid_argument);
  Piece open = rectangle(.1, .1);
  open.outline.pop_back();
  EXPECT_THROW(add_allowance(open), std::invalid_argument);
  EXPECT_THROW(add_allowance(Piece{}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
