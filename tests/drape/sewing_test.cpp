#include "drape/sewing.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "body/figure.h"
#include "collide/intersections.h"
#include "drape/dress.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

Placement facing_front(double x, double y, double z) { return {Eigen::Matrix3d::Identity(), {x, y, z}}; }

Placement facing_back(double x, double y, double z) {
  return {Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()).toRotationMatrix(), {x, y, z}};
}

const Body& figure_body() {
  static const Body body = make_body(figure());
  return body;
}

double widest(const LoosePanels& cloth) {
  double gap = 0;
  for (const double g : stitch_gaps(cloth)) gap = std::max(gap, g);
  return gap;
}

// Two strips to be joined, and a curtain between them, wider and higher than both.
TEST(Sewing, ClothThatIsInTheWayIsNotPassedThrough) {
  Pattern pattern;
  pattern.pieces = {rectangle("near", .06, .06), rectangle("curtain", .4, .4), rectangle("far", .06, .06)};
  pattern.seams = {{"joint", span("near", 1, "top"), span("far", 1, "top", 1, 0), false}};
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  std::vector<Eigen::Matrix3Xd> placed;
  const double z[] = {.48, .5, .52};
  for (std::size_t p = 0; p < 3; ++p) {
    Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Constant(3, garment.panels[p].rest.cols(), z[p]);
    flat.topRows<2>() = garment.panels[p].rest;
    if (p != 1) flat.topRows<2>().array() += .17;
    if (p == 2) flat.row(0) = .4 - flat.row(0).array();  // its right side looks away from the first
    flat.row(1).array() += 1;
    placed.push_back(flat);
  }
  LoosePanels cloth = loose_panels(garment, placed);
  ASSERT_TRUE(intersecting_triangles(cloth.positions, cloth.triangles).empty());
  draw_together({.shrinking_steps = 40, .holding_steps = 10}, figure_body(), cloth);
  EXPECT_TRUE(intersecting_triangles(cloth.positions, cloth.triangles).empty());
  EXPECT_TRUE(cloth.positions.allFinite());
}

TEST(Sewing, ADartClosesOnItself) {
  Pattern pattern;
  pattern.pieces = {polygon_piece("front", {{0, 0}, {.3, 0}, {.3, .2}, {.165, .2}, {.15, .1}, {.135, .2}, {0, .2}})};
  pattern.seams = {{"dart", span("front", 1, "e3"), span("front", 1, "e4", 1, 0), false}};
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .02}));
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Constant(3, garment.panels[0].rest.cols(), .25);
  flat.topRows<2>() = garment.panels[0].rest;
  flat.row(1).array() += 1;
  LoosePanels cloth = loose_panels(garment, {flat});
  const double before = widest(cloth);
  draw_together({.shrinking_steps = 60, .holding_steps = 20}, figure_body(), cloth);
  EXPECT_NEAR(before, .03, 1e-9);
  EXPECT_LT(widest(cloth), .5e-3);
  double longest = 0;  // the cloth round it is not torn
  for (const Tie& edge : cloth.edges)
    longest = std::max(longest, (cloth.positions.col(edge.a) - cloth.positions.col(edge.b)).norm() / edge.length);
  EXPECT_LT(longest, 1.1);
}

TEST(Sewing, APanelThatStartsNarrowedUnfoldsToTheWidthItIsCutWith) {
  Pattern pattern;
  pattern.pieces = {rectangle("front", .3, .1)};
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Constant(3, garment.panels[0].rest.cols(), .4);
  flat.topRows<2>() = garment.panels[0].rest;
  flat.row(0) *= .5;
  flat.row(1).array() += 1;
  const auto width = [](const LoosePanels& cloth) {
    return cloth.positions.row(0).maxCoeff() - cloth.positions.row(0).minCoeff();
  };
  LoosePanels cloth = loose_panels(garment, {flat});
  LoosePanels early = cloth;
  draw_together({.shrinking_steps = 80, .holding_steps = 40, .unfold = true}, figure_body(), cloth);
  EXPECT_NEAR(width(cloth), .3, 3e-3);
  double at_half = 0;
  const auto watch = [&](int step, int) {
    if (step == 40) at_half = width(early);
  };
  draw_together({.shrinking_steps = 80, .holding_steps = 0, .unfold = true, .progress = watch}, figure_body(), early);
  EXPECT_NEAR(at_half, .15, 1e-3) << "not before the stitches are nearly closed";
}

// A sleeve of two rectangles, placed flat before and behind the arm as if it hung 30 degrees from the level: the figure's arm
// hangs 45.
Pattern sleeve() {
  Pattern pattern;
  pattern.pieces = {rectangle("front", .2, .17, {0, -.085}), rectangle("back", .2, .17, {-.2, -.085})};
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(-std::numbers::pi / 6, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector3d shoulder(.16, 1.35, 0);
  const Eigen::Vector3d along = turn.col(0);
  Placement front = facing_front(0, 0, 0), back = facing_back(0, 0, 0);
  front.rotation = turn * front.rotation;
  back.rotation = turn * back.rotation;
  front.translation = shoulder + .15 * along + Eigen::Vector3d(0, 0, .15);
  back.translation = shoulder + .15 * along - Eigen::Vector3d(0, 0, .15);
  pattern.pieces[0].placement = {front};
  pattern.pieces[1].placement = {back};
  pattern.seams = {{"over", span("front", 1, "top"), span("back", 1, "top", 1, 0), false},
                   {"under", span("front", 1, "bottom"), span("back", 1, "bottom", 1, 0), false}};
  return pattern;
}

TEST(Dress, ASleeveClosesRoundTheArmItWasPlacedAt) {
  const Pattern pattern = sleeve();
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .025}));
  const Dressed dressed = dress(pattern, garment, figure_body());
  EXPECT_TRUE(dressed.report.ok()) << (dressed.report.findings.empty() ? "" : in_words(dressed.report.findings[0]));
  EXPECT_EQ(dressed.self_intersections, 0);
  EXPECT_TRUE(dressed.links_ok);
  EXPECT_TRUE(dressed.open_seams.empty());
  ASSERT_EQ(dressed.openings.size(), 2u);
  for (const Opening& opening : dressed.openings) EXPECT_EQ(opening.limbs, std::vector<std::string>{"hand.L"});
}

TEST(Dress, ASkirtSewnBesideTheBodyIsRefused) {
  Pattern pattern;
  pattern.pieces = {rectangle("front", .3, .2), rectangle("back", .3, .2, {-.3, 0})};
  pattern.pieces[0].placement = {facing_front(1, .7, .1)};
  pattern.pieces[1].placement = {facing_back(1, .7, -.1)};
  pattern.seams = {{"left side", span("front", 1, "right"), span("back", 1, "left", 1, 0), false},
                   {"right side", span("back", 1, "right"), span("front", 1, "left", 1, 0), false}};
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .04}));
  const Dressed dressed = dress(pattern, garment, figure_body());
  EXPECT_FALSE(dressed.links_ok);
  ASSERT_FALSE(dressed.report.ok());
  EXPECT_EQ(dressed.report.findings[0].code, "drape.not-around-body");
}

// Strips whose middles would have to meet inside the trunk, and strips too far apart.
Pattern two_strips(double apart) {
  Pattern pattern;
  pattern.pieces = {rectangle("front", .06, .06), rectangle("back", .06, .06, {-.06, 0})};
  pattern.pieces[0].placement = {facing_front(-.03, 1, apart / 2)};
  pattern.pieces[1].placement = {facing_back(-.03, 1, -apart / 2)};
  pattern.seams = {{"left side", span("front", 1, "right"), span("back", 1, "left", 1, 0), false}};
  return pattern;
}

TEST(Dress, WhatCanOnlyMeetInsideTheBodyIsRefused) {
  const Pattern pattern = two_strips(.4);
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  const Dressed dressed = dress(pattern, garment, figure_body());
  EXPECT_FALSE(dressed.report.ok());
}

TEST(Dress, ASeamThatDoesNotCloseIsNamed) {
  const Pattern pattern = two_strips(4);
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  const Dressed dressed = dress(pattern, garment, figure_body(), {.shrinking_steps = 20, .holding_steps = 0});
  ASSERT_FALSE(dressed.report.ok());
  ASSERT_EQ(dressed.open_seams.size(), 1u);
  EXPECT_NE(dressed.open_seams[0].find("left side"), std::string::npos);
  EXPECT_EQ(dressed.report.findings[0].code, "drape.seam-open");
}

}  // namespace
}  // namespace toile::test
