#include "drape/dress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "body/figure.h"
#include "drape/placement.h"
#include "geometry/topology.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

// Front and back of a straight skirt for the figure's trunk, 30 cm across.
Pattern two_panel_skirt() {
  Pattern pattern;
  const double half = std::numbers::pi * trunk_radius * 1.08;
  pattern.pieces = {rectangle("front", half, .2), rectangle("back", half, .2)};
  pattern.pieces[0].body_part = {BodyPart{.angle = 0}};
  pattern.pieces[1].body_part = {BodyPart{.angle = std::numbers::pi}};
  pattern.seams = {{"left side", span("front", 1, "right"), span("back", 1, "left", 1, 0), false},
                   {"right side", span("back", 1, "right"), span("front", 1, "left", 1, 0), false}};
  return pattern;
}

TEST(Dress, ASkirtOfTwoPanelsClosesRoundTheBody) {
  const Pattern pattern = two_panel_skirt();
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .025}));
  const Body body = make_body(figure());
  const Dressed dressed = dress(pattern, garment, body);
  EXPECT_TRUE(dressed.report.ok()) << (dressed.report.findings.empty() ? "" : in_words(dressed.report.findings[0]));
  EXPECT_LT(dressed.seam_gap, .5e-3);
  ASSERT_TRUE(dressed.positions.allFinite());
  const auto loops = boundary_loops(garment.triangles);
  ASSERT_EQ(loops.size(), 2u);
  for (const auto& loop : loops) {
    double turned = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Eigen::Vector3d a = dressed.positions.col(loop[i]), b = dressed.positions.col(loop[(i + 1) % loop.size()]);
      turned += std::atan2(a.x() * b.z() - a.z() * b.x(), a.x() * b.x() + a.z() * b.z());
    }
    EXPECT_NEAR(std::abs(turned), 2 * std::numbers::pi, 1e-6);
  }
  for (Eigen::Index v = 0; v < dressed.positions.cols(); ++v)
    EXPECT_GT(body.distance.distance(dressed.positions.col(v)), -.5e-3) << v;
  const Dressed again = dress(pattern, garment, body);
  EXPECT_TRUE((dressed.positions.array() == again.positions.array()).all());
}

TEST(Dress, APieceWithoutAPlaceIsRefusedByName) {
  Pattern pattern = two_panel_skirt();
  pattern.pieces[1].body_part.clear();
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .05}));
  try {
    place_panels(pattern, garment, make_body(figure()));
    FAIL();
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "drape.no-placement");
    EXPECT_NE(bad.finding().place.find("back"), std::string::npos);
    EXPECT_FALSE(bad.finding().remedy.empty());
  }
}

// Two panels of a tube for a limb, 20 cm long.
Eigen::Matrix3Xd placed_tube(BodyPart on, const Body& body) {
  Pattern pattern;
  pattern.pieces = {rectangle("front", .25, .2), rectangle("back", .25, .2)};
  pattern.pieces[0].body_part = {on};
  on.angle += std::numbers::pi;
  pattern.pieces[1].body_part = {on};
  const auto placed = place_panels(pattern, sew(pattern, triangulate(pattern, {.edge_length = .05})), body);
  Eigen::Matrix3Xd all(3, placed[0].cols() + placed[1].cols());
  all << placed[0], placed[1];
  return all;
}

TEST(Placement, OnALimbBeginsAtTheHeightOfItsLevel) {
  const Body body = make_body(figure());
  const Eigen::Matrix3Xd leg = placed_tube({.part = "leg.L", .level = "thigh.L:1", .drop = .05}, body);  // the knee, .45 m up
  EXPECT_NEAR(leg.row(1).maxCoeff(), .40, 1e-9);
  EXPECT_NEAR(leg.row(0).mean(), leg_x, 5e-3);
  const Eigen::Matrix3Xd high = placed_tube({.part = "leg.R", .level = "hip", .drop = .10}, body);
  EXPECT_NEAR(high.row(1).maxCoeff(), .75, 1e-9);
}

TEST(Placement, OnAnArmBeginsAtTheShoulderOrWhereItsAxisHasTheHeight) {
  const Body body = make_body(figure());  // arms slope down by 45 degrees from (.16, 1.35)
  const Eigen::Vector3d down = Eigen::Vector3d(1, -1, 0).normalized();
  const auto begins = [&](const Eigen::Matrix3Xd& tube) {
    return (down.transpose() * (tube.colwise() - Eigen::Vector3d(.16, 1.35, 0))).minCoeff();
  };
  EXPECT_NEAR(begins(placed_tube({.part = "arm.L", .level = "shoulder", .drop = .1}, body)), .1, 1e-9);
  EXPECT_NEAR(begins(placed_tube({.part = "arm.L", .level = "upperarm.L:0.5", .drop = .02}, body)), .17 / std::sqrt(2.) + .02,
              1e-9);
}

TEST(Placement, AtALevelBesideALimbThatIsHeldOutIsRefused) {
  Mannequin form = figure();
  for (Bone& bone : form.bones)
    if (bone.name == "forearm.L") bone.to = {.6, 1.35, 0};
  try {
    placed_tube({.part = "arm.L", .level = "waist"}, make_body(form));
    FAIL();
  } catch (const BadInput& bad) {
    EXPECT_EQ(bad.finding().code, "drape.level-beside-limb");
    EXPECT_NE(bad.finding().remedy.find("shoulder"), std::string::npos);
  }
}

}  // namespace
}  // namespace toile::test
