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

}  // namespace
}  // namespace toile::test
