#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "edit/mix/joint_stretch.h"
#include "edit/mix/unite.h"
#include "edit/worn_tube.h"
#include "garment/units.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

using testing::findings;
using testing::mixed;
using testing::mixed_worn;
using testing::Tube;
using testing::worn;

constexpr double pi = std::numbers::pi;
constexpr double hip = 0.83;  // m above the floor

double area_of(const Pattern& pattern) {
  double area = 0;
  for (const Piece& piece : pattern.pieces) area += copies(piece) * signed_area(piece);
  return area;
}

// That what comes after the edit can work with the pattern: it can be meshed and sewn anew, into a surface of that area.
void expect_sound(const Target& target) {
  ASSERT_TRUE(target.pattern);
  check(target.garment);
  const GarmentMesh again = sew(*target.pattern, triangulate(*target.pattern, {.edge_length = 25e-3}));
  EXPECT_EQ(again.panels.size(), target.garment.panels.size());
  double area = 0, anew = 0;
  for (const Eigen::Matrix2d& t : rest_triangles(target.garment)) {
    EXPECT_GT(t.determinant(), 0);
    area += t.determinant() / 2;
  }
  for (const Eigen::Matrix2d& t : rest_triangles(again)) anew += t.determinant() / 2;
  EXPECT_NEAR(area, anew, 1e-3 * area);
  for (const Seam& seam : target.pattern->seams)
    EXPECT_NEAR(span_length(*target.pattern, seam.a), span_length(*target.pattern, seam.b), 1e-4) << seam.name;
}

TEST(MixUnite, StripsOfOneCylinderBecomeLongerStrips) {
  const Target target = mixed({}, {.top = 1.0, .bottom = 0.4}, {{"loop", "hip"}});
  expect_sound(target);
  ASSERT_EQ(target.pattern->pieces.size(), 1u);
  EXPECT_EQ(copies(target.pattern->pieces[0]), 4);
  EXPECT_EQ(findings(target, "edit.united"), 4);
  EXPECT_EQ(findings(target, "edit.seam-kept"), 0);
  EXPECT_EQ(findings(target, "edit.grain-differs"), 0);
  EXPECT_NEAR(area_of(*target.pattern), 2 * pi * 0.30 * 0.80, 2e-3);
  EXPECT_EQ(target.pattern->pieces[0].notches.size(), 2u);
  // Sides run through, in one edge and one seam each.
  EXPECT_EQ(target.pattern->pieces[0].outline.size(), 4u);
  EXPECT_EQ(target.pattern->seams.size(), 4u);
  for (const Edge& edge : target.pattern->pieces[0].outline) EXPECT_TRUE(is_straight(edge, 1e-4)) << edge.id;
  for (const Notch& notch : target.pattern->pieces[0].notches) {
    EXPECT_EQ(notch.edge, "side_right");
    EXPECT_TRUE(std::abs(notch.at - 0.15 / 0.8) < 2e-3 || std::abs(notch.at - 0.73 / 0.8) < 2e-3) << notch.at;
  }
}

TEST(MixUnite, StripsOfOneConeBecomeLongerSectors) {
  const Tube upper{.radius = 0.25, .top = 1.1, .bottom = 0.6, .flare = 0.3};
  const Tube lower{.radius = testing::radius_at(upper, 1.0), .top = 1.0, .bottom = 0.4, .flare = 0.3};
  const Target target = mixed(upper, lower, {{"loop", "hip"}});
  expect_sound(target);
  ASSERT_EQ(target.pattern->pieces.size(), 1u);
  EXPECT_EQ(findings(target, "edit.united"), 4);
  const double slant = std::hypot(1.0, 0.3), low = testing::radius_at(upper, 0.4);
  EXPECT_NEAR(area_of(*target.pattern), pi * (0.25 + low) * slant * 0.7, 5e-3);
}

TEST(MixUnite, KeepsASeamWhereATubeOpensIntoACone) {
  const Tube lower{.radius = 0.30, .top = hip, .bottom = 0.4, .flare = 0.25};
  const Tube longer{.radius = 0.30 - 0.25 * 0.2, .top = hip + 0.2, .bottom = 0.4, .flare = 0.25};
  for (const Tube& cone : {longer}) {
    const Target target = mixed({}, cone, {{"loop", "hip"}});
    expect_sound(target);
    EXPECT_EQ(target.pattern->pieces.size(), 2u);
    EXPECT_EQ(findings(target, "edit.united"), 0);
    EXPECT_EQ(findings(target, "edit.seam-kept"), 4);
  }
  // At the free edge of the cone there is a seam in any case.
  EXPECT_EQ(findings(mixed({}, lower, {{"loop", "hip"}}), "edit.united"), 0);
}

// Unrolled, the ring of a cone turns by 2 pi sin(slope) in all, that of a tube not at all (Gauss-Bonnet).
TEST(MixUnite, CurvatureOfATubeThatOpensIntoAConeIsThatOfTheCone) {
  const Tube cone{.radius = 0.25, .top = hip + 0.2, .bottom = 0.4, .flare = 0.25};
  const Target target = mixed({}, cone, {{"loop", "hip"}});
  const double all = -2 * pi * 0.25 / std::hypot(1.0, 0.25);
  for (std::size_t s = 0; s < target.pattern->seams.size(); ++s) {
    if (target.pattern->seams[s].a.edge != "mix") continue;
    const JointStretch stretch =
        joint_stretch(*target.pattern, target.garment, target.positions, static_cast<int>(s), 0.01 * 1.7);
    EXPECT_NEAR(stretch.length, 2 * pi * 0.30 / 4, 2e-3);
    // All but what lies in the side seams, a column of vertices in about nineteen.
    EXPECT_NEAR(stretch.curvature, all / 4 * 18 / 19, 0.03);
    EXPECT_NEAR(stretch.turns_apart, -stretch.curvature, 0.03);
  }
}

TEST(MixUnite, CopiesThatAreNotJoinedStayAPieceOfTheirOwn) {
  const WornGarment own = worn({});
  Pattern pattern = own.pattern;
  pattern.pieces.push_back(pattern.pieces[0]);
  pattern.pieces[1].name = "other";
  pattern.seams = {{"top", {"strip", 2, "top", 0, 1}, {"other", 3, "top", 1, 0}, false}};
  pattern.pieces[1].outline = testing::strip_of({}).outline;
  // Turned over head first, so that both tops meet.
  for (Edge& edge : pattern.pieces[1].outline)
    for (OutlinePoint& point : edge.points) point.at = -point.at;
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = 40e-3}));
  const auto one = whole_edges(pattern, 0);
  ASSERT_TRUE(one);
  const United united = unite(pattern, garment, rest_triangles(garment), *one);
  check(united.garment);
  ASSERT_EQ(united.pattern.pieces.size(), 3u);
  EXPECT_TRUE(united.pattern.seams.empty());
  int panels = 0;
  for (const Piece& piece : united.pattern.pieces) panels += copies(piece);
  EXPECT_EQ(panels, 7);
  EXPECT_EQ(copies(united.pattern.pieces[static_cast<std::size_t>(united.piece)]), 1);
  EXPECT_NEAR(signed_area(united.pattern.pieces[static_cast<std::size_t>(united.piece)]),
              2 * signed_area(own.pattern.pieces[0]), 1e-6);
  EXPECT_LT(united.edges_apart, 1e-9);
  EXPECT_EQ(triangle_count(united.garment), triangle_count(garment));
  EXPECT_EQ(united.garment.vertex_count, garment.vertex_count);
}

TEST(MixUnite, KeepsASeamWhenAsked) {
  const Target target = mixed({}, {}, {{"loop", "hip"}, {"unite", "never"}});
  EXPECT_EQ(target.pattern->pieces.size(), 2u);
  EXPECT_EQ(findings(target, "edit.seam-kept"), 4);
}

TEST(MixUnite, KeepsASeamWhereSeamsOfOneMeetTheMiddleOfTheOther) {
  const Target target = mixed({.panels = 4}, {.panels = 6}, {{"loop", "hip"}});
  EXPECT_EQ(findings(target, "edit.united"), 0);
  EXPECT_GT(findings(target, "edit.seam-kept"), 4);
}

TEST(MixUnite, PiecesCutTheOtherWayOverAreTurnedOver) {
  const Target target = mixed({}, {.top = 1.0, .bottom = 0.4, .mirrored = true}, {{"loop", "hip"}});
  expect_sound(target);
  ASSERT_EQ(target.pattern->pieces.size(), 1u);
  const Piece& piece = target.pattern->pieces[0];
  EXPECT_EQ(copies(piece), 4);
  EXPECT_GT(signed_area(piece), 0);
  EXPECT_NEAR(area_of(*target.pattern), 2 * pi * 0.30 * 0.80, 2e-3);
  const Target other = mixed({.mirrored = true}, {.top = 1.0, .bottom = 0.4, .mirrored = true}, {{"loop", "hip"}});
  expect_sound(other);
  ASSERT_EQ(other.pattern->pieces.size(), 1u);
  EXPECT_EQ(other.pattern->pieces[0].mirrored_quantity, 4);
}

TEST(MixUnite, SaysWhenGrainLinesDiffer) {
  const Target target = mixed({}, {.top = 1.0, .bottom = 0.4, .turned = 20 * units::degree}, {{"loop", "hip"}});
  ASSERT_EQ(target.pattern->pieces.size(), 1u);
  EXPECT_EQ(findings(target, "edit.grain-differs"), 4);
}

TEST(MixUnite, LaterEditsGoOnWithUnitedPieces) {
  const Target target = mixed({}, {.top = 1.0, .bottom = 0.4}, {{"loop", "hip"}});
  const Target longer = find_operation("length").apply(
      {*target.pattern, target.garment, target.positions, testing::body_in_tube()}, {{"loop", "hem"}, {"by", "5 cm"}});
  EXPECT_NEAR(longer.positions.row(1).minCoeff(), 0.35, 2e-3);
  const WornGarment once{*target.pattern, target.garment, target.positions, 25e-3, {}};
  const Target twice = mixed_worn(once, worn({.top = 0.9, .bottom = 0.3}), {{"loop", "thigh.L:0.4"}});
  EXPECT_GE(twice.pattern->pieces.size(), 1u);
}

}  // namespace
}  // namespace toile
