#include "drape/openings.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "body/figure.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

using Limbs = std::vector<std::string>;

// A tube of two rectangles, .6 m round and .2 m long.
struct Tube {
  Pattern pattern;
  GarmentMesh garment;
};

Tube tube() {
  Tube made;
  made.pattern.pieces = {rectangle("front", .3, .2), rectangle("back", .3, .2)};
  made.pattern.seams = {{"left side", span("front", 1, "right"), span("back", 1, "left", 1, 0), false},
                        {"right side", span("back", 1, "right"), span("front", 1, "left", 1, 0), false}};
  made.garment = sew(made.pattern, triangulate(made.pattern, {.edge_length = .04}));
  return made;
}

// The tube round the line from `from`, with radius `radius`.
Eigen::Matrix3Xd round(const GarmentMesh& garment, const Eigen::Vector3d& from, const Eigen::Vector3d& along, double radius) {
  Eigen::Matrix3Xd positions(3, garment.vertex_count);
  const Eigen::Vector3d across = along.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d other = across.cross(along).normalized();
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    for (Eigen::Index v = 0; v < garment.panels[p].rest.cols(); ++v) {
      const Eigen::Vector2d at = garment.panels[p].rest.col(v);
      const double angle = std::numbers::pi * (static_cast<double>(p) + at.x() / .3);
      positions.col(garment.welded[p](v)) =
          from + at.y() * along.normalized() + radius * (std::cos(angle) * across + std::sin(angle) * other);
    }
  return positions;
}

std::vector<Opening> of_tube(const Eigen::Vector3d& from, const Eigen::Vector3d& along, double radius) {
  const Tube made = tube();
  return openings(made.garment, round(made.garment, from, along, radius), figure());
}

Limbs limbs(const std::vector<Opening>& openings, std::size_t which) { return openings.at(which).limbs; }

TEST(Openings, ATubeRoundTheWaistHoldsWhatIsAboveIt) {
  const auto found = of_tube({0, .95, 0}, {0, 1, 0}, .3);
  ASSERT_EQ(found.size(), 2u);
  for (const Opening& opening : found) {
    EXPECT_EQ(opening.limbs, (Limbs{"head", "hand.L", "hand.R"}));
    EXPECT_NEAR(opening.length, .6, 1e-9);
    EXPECT_EQ(opening.pieces, (Limbs{"front", "back"}));
    EXPECT_FALSE(opening.wound);
  }
}

TEST(Openings, ATubeRoundBothLegsOneLegOrAnArm) {
  EXPECT_EQ(limbs(of_tube({0, .3, 0}, {0, 1, 0}, .3), 0), (Limbs{"foot.L", "foot.R"}));
  EXPECT_EQ(limbs(of_tube({.09, .3, 0}, {0, 1, 0}, .085), 0), (Limbs{"foot.L"}));
  EXPECT_EQ(limbs(of_tube({-.3, 1.21, 0}, {-1, -1, 0}, .1), 1), (Limbs{"hand.R"}));
  EXPECT_TRUE(limbs(of_tube({.6, .3, 0}, {0, 1, 0}, .1), 0).empty());
}

TEST(Openings, WhatIsWrongIsNamed) {
  const Tube made = tube();
  const Limbs none(2);
  const auto code = [&](std::vector<Opening> openings, const Limbs& sleeves) {
    const Report report = check_openings(openings, made.garment, sleeves);
    return report.findings.empty() ? std::string{} : report.findings.front().code;
  };
  auto worn = of_tube({0, .95, 0}, {0, 1, 0}, .3);
  EXPECT_EQ(code(worn, none), "");
  EXPECT_EQ(code(of_tube({.6, .3, 0}, {0, 1, 0}, .1), none), "drape.not-around-body");
  EXPECT_EQ(code(worn, {"hand.L", "hand.L"}), "") << "the hand is among what it holds";
  EXPECT_EQ(code(of_tube({-.3, 1.21, 0}, {-1, -1, 0}, .1), {"hand.L", ""}), "drape.linked-wrong");
  worn[0].limbs = {"head", "hand.L", "hand.R", "foot.L"};
  EXPECT_EQ(code(worn, none), "drape.linked-wrong") << "a foot beside the trouser leg";
  worn[0].limbs.clear();
  EXPECT_EQ(code(worn, none), "drape.linked-wrong");
  worn[0].length = .1;
  EXPECT_EQ(code(worn, none), "") << "a keyhole";
  const Report report = check_openings(of_tube({-.3, 1.21, 0}, {-1, -1, 0}, .1), made.garment, {"hand.L", "hand.L"});
  ASSERT_FALSE(report.ok());
  EXPECT_NE(report.findings[0].place.find("front"), std::string::npos);
  EXPECT_FALSE(report.findings[0].remedy.empty());
}

// A hood: upright round the neck, bent forwards over the head, its other end before the face.
TEST(Openings, ALimbThatClothClosesOverTakesAnotherWayOut) {
  const Tube made = tube();
  const Mannequin form = figure();
  const LimbChain head = limb_chains(form).front();
  ASSERT_EQ(head.name, "head");
  const Eigen::Vector3d middle = head.other_ways.at(0)[head.other_ways[0].size() - 2];
  const double bend = .12;
  const Eigen::Vector3d centre = middle + Eigen::Vector3d(0, -.09, bend);
  Eigen::Matrix3Xd positions(3, made.garment.vertex_count);
  for (std::size_t p = 0; p < 2; ++p)
    for (Eigen::Index v = 0; v < made.garment.panels[p].rest.cols(); ++v) {
      const Eigen::Vector2d at = made.garment.panels[p].rest.col(v);
      const double round = std::numbers::pi * (static_cast<double>(p) + at.x() / .3);
      const double turned = std::numbers::pi / 2 * at.y() / .2;
      const double from_centre = bend + .1 * std::cos(round);
      positions.col(made.garment.welded[p](v)) =
          centre + Eigen::Vector3d(.1 * std::sin(round), from_centre * std::sin(turned), -from_centre * std::cos(turned));
    }
  const auto found = openings(made.garment, positions, form);
  ASSERT_EQ(found.size(), 2u);
  for (const Opening& opening : found) EXPECT_EQ(opening.limbs, Limbs{"head"});
  EXPECT_TRUE(check_openings(found, made.garment, Limbs(2)).ok());
  EXPECT_TRUE(check_caught(made.garment, positions, form).ok());
}

TEST(Openings, ALimbInsideTheClothIsCaught) {
  const Tube made = tube();
  const Mannequin form = figure();
  EXPECT_TRUE(check_caught(made.garment, round(made.garment, {0, .95, 0}, {0, 1, 0}, .3), form).ok());
  // Its wall stands across both legs.
  const Report report = check_caught(made.garment, round(made.garment, {-.1, .4, 0}, {1, 0, 0}, .1), form);
  ASSERT_FALSE(report.ok());
  EXPECT_EQ(report.findings.front().code, "drape.linked-wrong");
  EXPECT_NE(report.findings.front().place.find("foot"), std::string::npos);
}

TEST(Openings, AStandWithoutLimbsHasAnUpperAndALowerEnd) {
  Mannequin stand = figure();
  stand.bones.clear();
  const Tube made = tube();
  for (const Opening& opening : openings(made.garment, round(made.garment, {0, .95, 0}, {0, 1, 0}, .3), stand))
    EXPECT_EQ(opening.limbs.size(), 1u);
}

}  // namespace
}  // namespace toile::test
