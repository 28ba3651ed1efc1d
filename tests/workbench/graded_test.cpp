#include "workbench/graded.h"

#include <gtest/gtest.h>

#include <cmath>

namespace toile {
namespace {

// A quarter disc of radius `r`: two straight edges and an arc of `count` chords.
Pattern quarter(double r, int count) {
  Edge bottom{"bottom", {{{0, 0}, true, {}}, {{r, 0}, true, {}}}, {}, false};
  Edge arc{"arc", {}, {}, false};
  for (int i = 0; i <= count; ++i) {
    const double angle = M_PI / 2 * i / count;
    arc.points.push_back({{r * std::cos(angle), r * std::sin(angle)}, i == 0 || i == count, {}});
  }
  Edge side{"side", {{{0, r}, true, {}}, {{0, 0}, true, {}}}, {}, false};
  Pattern pattern;
  pattern.pieces.resize(1);
  pattern.pieces[0].name = "QUARTER";
  pattern.pieces[0].outline = {bottom, arc, side};
  return pattern;
}

TEST(Graded, SizesHaveTheSamePoints) {
  const auto sizes = with_same_points({quarter(.3, 20), quarter(.32, 33), quarter(.34, 27)});
  for (const Pattern& size : sizes) {
    const auto& outline = size.pieces[0].outline;
    EXPECT_EQ(outline[0].points.size(), 2u);
    EXPECT_EQ(outline[1].points.size(), 34u);
    EXPECT_EQ(outline[2].points.size(), 2u);
    for (std::size_t e = 0; e < 3; ++e)
      EXPECT_LT((outline[e].points.back().at - outline[(e + 1) % 3].points.front().at).norm(), 1e-15);
  }
  // Chords of 20 over a quarter are off by r (1 - cos(pi/80)) at most.
  for (const OutlinePoint& point : sizes[0].pieces[0].outline[1].points)
    EXPECT_NEAR(point.at.norm(), .3, .3 * (1 - std::cos(M_PI / 80)) + 1e-12);
  EXPECT_EQ(sizes[1], quarter(.32, 33));  // the one with most is as it was
}

TEST(Graded, CornersSayWhatTheyMove) {
  const auto grades = turn_point_grades({quarter(.3, 9), quarter(.32, 9)});
  ASSERT_EQ(grades.size(), 3u);
  EXPECT_EQ(grades[1].edge, "arc");
  EXPECT_EQ(grades[1].moves[0], Eigen::Vector2d::Zero());
  EXPECT_NEAR((grades[1].moves[1] - Eigen::Vector2d(.02, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((grades[2].moves[1] - Eigen::Vector2d(0, .02)).norm(), 0, 1e-15);
}

TEST(Graded, OtherPiecesAreRefused) {
  Pattern other = quarter(.3, 9);
  other.pieces[0].outline[1].id = "curve";
  EXPECT_THROW(with_same_points({quarter(.3, 9), other}), std::invalid_argument);
  EXPECT_NEAR(turn_point_grades({quarter(.3, 9), quarter(.32, 9)}, 1)[0].moves[1].norm(), 0, 1e-15);
  EXPECT_NEAR(turn_point_grades({quarter(.3, 9), quarter(.32, 9)}, 1)[0].moves[0].norm(),
              turn_point_grades({quarter(.3, 9), quarter(.32, 9)})[0].moves[1].norm(), 1e-15);
  EXPECT_THROW(turn_point_grades({quarter(.3, 9), Pattern{}}), std::invalid_argument);
}

}  // namespace
}  // namespace toile
