#include "drape/untangle.h"

#include <gtest/gtest.h>

#include <numbers>

#include "body/figure.h"
#include "collide/intersections.h"
#include "drape/side_by_side.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

// A sheet in front of the body, in which one inner vertex was pulled over its neighbours, of which one sticks out through it.
struct Crossed {
  GarmentMesh garment;
  Body body = make_body(figure());
  Eigen::Matrix3Xd flat, positions;

  Crossed() {
    Pattern pattern;
    pattern.pieces = {rectangle("front", .4, .4)};
    garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
    flat = Eigen::Matrix3Xd::Constant(3, garment.vertex_count, .4);
    for (Eigen::Index v = 0; v < garment.panels[0].rest.cols(); ++v)
      flat.col(garment.welded[0](v)).head<2>() = garment.panels[0].rest.col(v) + Eigen::Vector2d(0, 1);
    positions = flat;
    Eigen::Index one = 0, other = 0;
    (flat.topRows<2>().colwise() - Eigen::Vector2d(.2, 1.2)).colwise().norm().minCoeff(&one);
    (flat.topRows<2>().colwise() - Eigen::Vector2d(.26, 1.2)).colwise().norm().minCoeff(&other);
    positions.col(one) += Eigen::Vector3d(.12, 0, .01);
    positions.col(other).z() += .03;  // through what was pulled over it
  }
};

TEST(Untangle, TakesOutWhatCrossesAndLeavesTheRestNearWhereItWas) {
  Crossed sheet;
  ASSERT_FALSE(intersecting_triangles(sheet.positions, sheet.garment.triangles).empty());
  EXPECT_TRUE(untangle(sheet.garment, sheet.body, 1e-3, {}, sheet.positions));
  EXPECT_TRUE(intersecting_triangles(sheet.positions, sheet.garment.triangles).empty());
  EXPECT_LT((sheet.positions - sheet.flat).colwise().norm().maxCoeff(), 5e-3);
}

TEST(Untangle, LeavesClothThatDoesNotCrossAsItIs) {
  Crossed sheet;
  sheet.positions = sheet.flat;
  EXPECT_FALSE(untangle(sheet.garment, sheet.body, 1e-3, {}, sheet.positions));
  EXPECT_TRUE((sheet.positions.array() == sheet.flat.array()).all());
}

TEST(SideBySide, UnequalPanelsKeepTheirOrderAndAreApartInEveryRow) {
  const double turn = 2 * std::numbers::pi, gap = .01;
  std::vector<RolledPanel> panels{{0, {.1, .2}, {.1, .2}}, {2, {.05, .05, .3}, {.05, .05, .1}}, {2.2, {.2}, {.2}}};
  std::vector<double> radii{.05, .05, .05};
  give_room(panels, gap, radii);
  for (std::size_t i = 0; i < 3; ++i) {
    const RolledPanel &one = panels[i], &next = panels[(i + 1) % 3];
    const double apart = next.angle - one.angle + (i == 2 ? turn : 0);
    EXPECT_GT(apart, 0);
    for (std::size_t row = 0; row < std::min(one.right.size(), next.left.size()); ++row)
      EXPECT_GE(apart * radii[row], one.right[row] + next.left[row] + gap - 1e-5) << i << " row " << row;
  }
}

TEST(SideBySide, PanelsWithRoomStayWhereTheyWere) {
  std::vector<RolledPanel> panels{{0, {.1}, {.1}}, {std::numbers::pi, {.1}, {.1}}};
  std::vector<double> radii{.3};
  give_room(panels, .01, radii);
  EXPECT_EQ(radii[0], .3);
  EXPECT_NEAR(panels[1].angle - panels[0].angle, std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace toile::test
