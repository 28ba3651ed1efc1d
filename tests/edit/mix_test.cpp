#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <set>

#include "draft/redraw.h"
#include "edit/worn_tube.h"
#include "geometry/surface_distance.h"

namespace toile {
namespace {

constexpr double pi = std::numbers::pi;

using testing::mixed;
using testing::Tube;
using testing::worn;

Finding refusal(const Tube& first, const Tube& second, const EditArguments& arguments) {
  try {
    mixed(first, second, arguments);
  } catch (const BadInput& bad) {
    return bad.finding();
  }
  return {};
}

double radius(const Eigen::Vector3d& at) { return std::hypot(at.x(), at.z()); }

// "hip" is 0.83 m above the floor.
TEST(Mix, CoaxialCylindersOfOneRadiusMakeOneCylinder) {
  const Target target = mixed({.panels = 4}, {.top = 1.0, .bottom = 0.4, .panels = 4}, {{"loop", "hip"}});
  ASSERT_TRUE(target.pattern);
  check(target.garment);
  ASSERT_EQ(target.positions.cols(), target.garment.vertex_count);
  EXPECT_NEAR(target.positions.row(1).maxCoeff(), 1.20, 1e-3);
  EXPECT_NEAR(target.positions.row(1).minCoeff(), 0.40, 1e-3);
  for (Eigen::Index v = 0; v < target.positions.cols(); ++v) EXPECT_NEAR(radius(target.positions.col(v)), 0.30, 1.5e-3);
  double area = 0;
  for (const Piece& piece : target.pattern->pieces) area += copies(piece) * signed_area(piece);
  EXPECT_NEAR(area, 2 * pi * 0.30 * 0.80, 2e-3);
}

// The joint is longer on one side, so that pieces are redrawn and their cloth is stretched unevenly along the edges.
TEST(Mix, PiecesDrawnAnewKnowWhereTheirBoundaryLies) {
  const Target target = mixed({.radius = 0.30, .panels = 4}, {.radius = 0.32, .panels = 4}, {{"loop", "hip"}});
  const RestShape rest = rest_shape(target.garment), laid = rest_on_outlines(*target.pattern, target.garment, rest);
  for (std::size_t p = 0; p < rest.size(); ++p) EXPECT_LT((rest[p] - laid[p]).cwiseAbs().maxCoeff(), 1e-7) << p;
  const Redrawn again = redraw(*target.pattern, target.garment, rest);
  EXPECT_LT(again.max_deviation, 1e-4);
  EXPECT_LT(again.seam_mismatch, 1e-5);
}

TEST(Mix, KeepsNotchesGrainAndSeamsOfBothParts) {
  const Target target = mixed({.panels = 4}, {.top = 1.0, .bottom = 0.4, .panels = 6}, {{"loop", "hip"}});
  const Pattern& pattern = *target.pattern;
  ASSERT_EQ(pattern.pieces.size(), 2u);
  for (const Piece& piece : pattern.pieces) {
    EXPECT_EQ(piece.notches.size(), 1u) << piece.name;  // one of the two is on the other side of the cut
    EXPECT_TRUE(piece.grainline) << piece.name;
    ASSERT_TRUE(find_edge(piece, "mix")) << piece.name;
    EXPECT_TRUE(is_straight(*find_edge(piece, "mix"))) << piece.name;
  }
  int sides = 0;
  double joint = 0;
  for (const Seam& seam : pattern.seams) {
    EXPECT_NEAR(span_length(pattern, seam.a), span_length(pattern, seam.b), 1e-4) << seam.name;
    if (seam.a.edge == "mix")
      joint += span_length(pattern, seam.a);
    else
      ++sides;
  }
  EXPECT_EQ(sides, 10);
  EXPECT_NEAR(joint, 2 * pi * 0.30, 1e-3);
}

TEST(Mix, CylindersOfTwoRadiiMeetBetweenThem) {
  const Target target = mixed({.radius = 0.30, .panels = 4}, {.radius = 0.32, .panels = 6}, {{"loop", "hip"}});
  for (const int v : target.held) EXPECT_NEAR(radius(target.positions.col(v)), 0.31, 2e-3);
  const Pattern& pattern = *target.pattern;
  double joint[2] = {0, 0};
  for (const Seam& seam : pattern.seams) {
    if (seam.a.edge != "mix") continue;
    joint[0] += span_length(pattern, seam.a);
    joint[1] += span_length(pattern, seam.b);
  }
  EXPECT_NEAR(joint[0], joint[1], 2e-3);
  EXPECT_NEAR(joint[0], 2 * pi * 0.31, 0.01);
}

TEST(Mix, OfAGarmentWithItselfIsItself) {
  const Target target = mixed({}, {}, {{"loop", "hip"}});
  const WornGarment own = worn({});
  EXPECT_LT((target.positions - target.source).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(surface_distance({target.positions, target.garment.triangles}, {own.drape, own.garment.triangles}).hausdorff, 1e-3);
}

TEST(Mix, KeepsWhatIsBeyondWhenAsked) {
  const Target target = mixed({.panels = 4}, {.top = 1.1, .bottom = 0.6, .panels = 6}, {{"loop", "hip"}, {"keep", "beyond"}});
  EXPECT_NEAR(target.positions.row(1).maxCoeff(), 1.1, 1e-3);
  EXPECT_NEAR(target.positions.row(1).minCoeff(), 0.5, 1e-3);
}

TEST(Mix, SewsWholeGarmentsTogetherAtTheirEdges) {
  const Target target = mixed({.bottom = 0.9}, {.top = 0.88, .panels = 5}, {{"loop", "hem"}});
  EXPECT_EQ(target.pattern->pieces.size(), 2u);
  EXPECT_NEAR(target.positions.row(1).minCoeff(), 0.5, 5e-3);
  for (const int v : target.held) EXPECT_NEAR(target.positions(1, v), 0.89, 1e-3);
}

// Paper Sec. 5: within 1 % of the body's height of the joint both styles count, so a tube opens into a cone a little before and
// goes on as a tube a little after.
TEST(Mix, TakesOnBothStylesNearTheJoint) {
  const Tube cone{.radius = 0.25, .top = 1.03, .bottom = 0.75, .flare = 0.25, .edge_length = 10e-3};  // 0.30 at the hip
  const auto slope_beside_joint = [](const Target& target, bool above) {
    const std::set<int> joint(target.held.begin(), target.held.end());
    double sum = 0, count = 0;
    for (Eigen::Index t = 0; t < target.garment.triangles.cols(); ++t) {
      Eigen::Matrix3d corners;
      int met = 0;
      for (int k = 0; k < 3; ++k) {
        corners.col(k) = target.positions.col(target.garment.triangles(k, t));
        met += static_cast<int>(joint.count(target.garment.triangles(k, t)));
      }
      const Eigen::Vector3d middle = corners.rowwise().mean();
      if (met < 2 || (middle.y() > 0.83) != above) continue;
      const Eigen::Vector3d normal = (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).normalized();
      sum += std::asin(normal.y());
      ++count;
    }
    return sum / count;
  };
  const Target hybrid = mixed({.top = 0.93, .bottom = 0.73, .edge_length = 10e-3}, cone, {{"loop", "hip"}});
  const double flare = std::atan(0.25);
  EXPECT_GT(slope_beside_joint(hybrid, true), 0.1 * flare);
  EXPECT_LT(slope_beside_joint(hybrid, true), 0.6 * flare);
  EXPECT_LT(slope_beside_joint(hybrid, false), 0.9 * flare);
  EXPECT_GT(slope_beside_joint(hybrid, false), 0.4 * flare);
  // Where the other garment ends at the joint there is nothing to take on.
  const Target sewn_on =
      mixed({.top = 0.93, .bottom = 0.83}, {.radius = 0.30, .top = 0.83, .bottom = 0.75, .flare = 0.25, .edge_length = 10e-3},
            {{"loop", "hem"}});
  EXPECT_LT(slope_beside_joint(sewn_on, true), 0.1 * flare);
  EXPECT_LT((sewn_on.positions - sewn_on.source).colwise().norm().maxCoeff(), 1e-3);
}

TEST(Mix, TakesALoopOfTheOtherGarmentByName) {
  const Target target =
      mixed({.bottom = 0.9}, {.top = 0.75, .bottom = 0.4, .panels = 5}, {{"loop", "hem"}, {"other_loop", "top"}});
  for (const int v : target.held) EXPECT_NEAR(target.positions(1, v), 0.825, 1e-3);
}

TEST(Mix, FindsTheBestPlaceInARegion) {
  // Both are cylinders of one radius: any level is as good, so the cut is no longer than a level one.
  const Target target = mixed({}, {.panels = 6}, {{"region", "spine_low:0.9..hip"}});
  for (const int v : target.held) {
    EXPECT_LT(target.positions(1, v), 1.04);
    EXPECT_GT(target.positions(1, v), 0.82);
  }
}

TEST(Mix, RefusesWhatCannotBeMeant) {
  EXPECT_EQ(refusal({}, {.top = 0.5, .bottom = 0.3}, {{"loop", "hip"}}).code, "edit.no-overlap");
  EXPECT_EQ(refusal({}, {}, {{"loop", "hip"}, {"keep", "left"}}).code, "edit.bad-side");
  EXPECT_EQ(refusal({}, {}, {{"loop", "hip"}, {"unite", "always"}}).code, "edit.bad-choice");
  EXPECT_EQ(refusal({}, {}, {{"loop", "armhole"}}).code, "edit.no-loop-there");
  EXPECT_EQ(refusal({}, {}, {{"region", "hip"}}).code, "edit.bad-region");
  EXPECT_EQ(refusal({}, {}, {{"region", "hip..waist"}}).code, "edit.bad-region");
  EXPECT_EQ(refusal({}, {}, {{"region", "waist..hip"}, {"other_loop", "hem"}}).code, "edit.two-parameters");
  EXPECT_EQ(refusal({}, {}, {{"loop", "hem"}, {"keep", "beyond"}}).code, "edit.nothing-left");
}

}  // namespace
}  // namespace toile
