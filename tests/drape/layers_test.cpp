#include "drape/layers.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "body/figure.h"
#include "collide/intersections.h"
#include "drape/dress.h"
#include "drape/fem/bending.h"
#include "drape/flat_layers.h"
#include "drape/mass_spring/cloth.h"
#include "drape/placement.h"
#include "drape/simulator.h"
#include "drape/stitches.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

constexpr double half_waist = std::numbers::pi * trunk_radius * .99;

// Front and back of a band at the waist of the figure, with a skirt and a shorter, wider one over it, all of half the girth.
Pattern skirt_and_overskirt() {
  Pattern pattern;
  const auto add = [&](const std::string& name, Piece piece, double drop) {
    for (const bool back : {false, true}) {
      piece.name = name + (back ? "_back" : "_front");
      piece.body_part = {BodyPart{.angle = back ? std::numbers::pi : 0, .drop = drop}};
      pattern.pieces.push_back(piece);
    }
    pattern.seams.push_back({name + " left", span(name + "_front", 1, "right"), span(name + "_back", 1, "left", 1, 0), false});
    pattern.seams.push_back({name + " right", span(name + "_back", 1, "right"), span(name + "_front", 1, "left", 1, 0), false});
  };
  const auto flared = [](double length, double flare) {
    Piece piece = polygon_piece("", {{-flare, 0}, {half_waist + flare, 0}, {half_waist, length}, {0, length}});
    const char* ids[] = {"bottom", "right", "top", "left"};
    for (std::size_t e = 0; e < 4; ++e) piece.outline[e].id = ids[e];
    return piece;
  };
  add("band", rectangle("", half_waist, .05), -.05);
  add("skirt", flared(.2, .02), 0);
  add("over", flared(.12, .03), 0);
  for (const char* hung : {"skirt", "over"})
    for (const char* half : {"_front", "_back"})
      pattern.seams.push_back({std::string(hung) + half, span("band" + std::string(half), 1, "bottom"),
                               span(hung + std::string(half), 1, "top", 1, 0), false});
  return pattern;
}

GarmentMesh sewn(const Pattern& pattern, double edge_length = .025) {
  return sew(pattern, triangulate(pattern, {.edge_length = edge_length}));
}

const Body& figure_body() {
  static const Body body = make_body(figure());
  return body;
}

using Layers = std::vector<int>;

TEST(PanelLayers, FollowTheOrderOfTheSeams) {
  Pattern pattern = skirt_and_overskirt();
  EXPECT_EQ(panel_layers(pattern, sewn(pattern)), (Layers{0, 0, 0, 0, 1, 1}));
  const std::size_t waist = pattern.seams.size() - 4;
  std::rotate(pattern.seams.begin() + static_cast<std::ptrdiff_t>(waist),
              pattern.seams.begin() + static_cast<std::ptrdiff_t>(waist) + 2, pattern.seams.end());
  EXPECT_EQ(panel_layers(pattern, sewn(pattern)), (Layers{0, 0, 1, 1, 0, 0}));
}

TEST(PanelLayers, FollowWhatThePiecesSayBeforeTheirPlacesAndTheirSeams) {
  const Pattern pattern = skirt_and_overskirt();
  const auto with = [&](std::size_t first, int layer) {
    Pattern changed = pattern;
    changed.pieces[first].layer = changed.pieces[first + 1].layer = layer;
    return changed;
  };
  EXPECT_EQ(panel_layers(with(4, 0), sewn(pattern)), (Layers{0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(panel_layers(with(2, 1), sewn(pattern)), (Layers{0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(panel_layers(with(4, 3), sewn(pattern)), (Layers{0, 0, 0, 0, 1, 1}));
  // In front of each other, the overskirt nearer to the body.
  const auto placed = [](Pattern changed) {
    for (std::size_t p = 0; p < 6; ++p) {
      const Eigen::AngleAxisd turn(p % 2 ? std::numbers::pi : 0, Eigen::Vector3d::UnitY());
      const double out = p / 2 == 2 ? .2 : .3;
      changed.pieces[p].placement = {Placement{turn.toRotationMatrix(), {0, 1, p % 2 ? -out : out}}};
    }
    return changed;
  };
  EXPECT_EQ(panel_layers(placed(pattern), sewn(pattern)), (Layers{0, 0, 1, 1, 0, 0}));
  EXPECT_EQ(panel_layers(placed(with(4, 1)), sewn(pattern)), (Layers{0, 0, 0, 0, 1, 1}));
}

TEST(PanelLayers, AreOneForAGarmentWithoutSuchASeam) {
  const Pattern pattern = gored_skirt();
  EXPECT_EQ(panel_layers(pattern, sewn(pattern, .06)), Layers(9, 0));
}

TEST(PanelLayers, CarryOverToWhatIsSewnToAPanelElsewhere) {
  Pattern pattern = skirt_and_overskirt();
  pattern.pieces.push_back(rectangle("flounce", 1, .1));
  pattern.seams.push_back({"", span("over_front", 1, "bottom"), span("flounce", 1, "top", 1, 0), false});
  // A flap over the flounce, in the overskirt's hem: a third layer.
  pattern.pieces.push_back(rectangle("flap", 1, .05));
  pattern.seams.push_back({"", span("over_front", 1, "bottom"), span("flap", 1, "top", 1, 0), false});
  EXPECT_EQ(panel_layers(pattern, sewn(pattern)), (Layers{0, 0, 0, 0, 1, 1, 1, 2}));
}

// How far outside the skirt the overskirt hangs at its vertices, m: along the ray from the trunk's axis. Vertices of the seam,
// and those with no skirt behind them, are left out.
std::vector<double> outside(const GarmentMesh& garment, const Eigen::Matrix3Xd& x) {
  std::vector<bool> on_band(static_cast<std::size_t>(garment.vertex_count), false);
  for (const std::size_t p : {0u, 1u})
    for (const int v : garment.welded[p]) on_band[static_cast<std::size_t>(v)] = true;
  std::vector<double> gaps;
  for (const std::size_t p : {4u, 5u})
    for (const int v : garment.welded[p]) {
      if (on_band[static_cast<std::size_t>(v)]) continue;
      const Eigen::Vector3d axis(0, x(1, v), 0);
      const Eigen::Vector3d ray = Eigen::Vector3d(x.col(v)) - axis;
      for (const std::size_t q : {2u, 3u})
        for (const auto& corners : garment.panels[q].triangles.colwise()) {
          Eigen::Matrix3d system;
          const Eigen::Vector3d a = x.col(garment.welded[q](corners(0)));
          system << ray, a - x.col(garment.welded[q](corners(1))), a - x.col(garment.welded[q](corners(2)));
          const Eigen::Vector3d at = system.inverse() * (a - axis);
          if (at(0) > 0 && at(1) >= 0 && at(2) >= 0 && at(1) + at(2) <= 1) gaps.push_back((1 - at(0)) * ray.norm());
        }
    }
  return gaps;
}

TEST(Layers, StartOutsideEachOther) {
  const Pattern pattern = skirt_and_overskirt();
  const auto placed = place_panels(pattern, sewn(pattern), figure_body());
  const auto radius = [&](std::size_t p) -> Eigen::RowVectorXd {
    return placed[p].colwise().norm().cwiseAbs2() - placed[p].row(1).cwiseAbs2();
  };
  for (const std::size_t p : {4u, 5u})
    for (const std::size_t q : {2u, 3u}) {
      const double low = placed[p].row(1).minCoeff();
      for (Eigen::Index v = 0; v < placed[q].cols(); ++v)
        if (placed[q](1, v) >= low) {
          EXPECT_GT(std::sqrt(radius(p).minCoeff()), std::sqrt(radius(q)(v)) + .015);
        }
    }
}

TEST(Layers, AreSewnAndHangInOrder) {
  for (const bool written_first : {false, true}) {
    Pattern pattern = skirt_and_overskirt();
    if (written_first) {  // the overskirt, but it says that it is the outer one
      std::rotate(pattern.seams.end() - 4, pattern.seams.end() - 2, pattern.seams.end());
      pattern.pieces[4].layer = pattern.pieces[5].layer = 1;
    }
    const GarmentMesh garment = sewn(pattern);
    const Dressed dressed = dress(pattern, garment, figure_body());
    ASSERT_TRUE(dressed.report.ok()) << in_words(dressed.report.findings.at(0));
    EXPECT_LT(dressed.seam_gap, .5e-3);
    EXPECT_EQ(dressed.openings.size(), 3u);
    auto gaps = outside(garment, dressed.positions);
    EXPECT_GT(gaps.size(), 60u);
    for (const double gap : gaps) EXPECT_GT(gap, 0);

    const Fabric fabric;
    const Drape drape = find_simulator("fem").drape({garment, dressed.positions, figure_body(), fabric, 1e-2});
    EXPECT_TRUE(drape.settled);
    EXPECT_EQ(drape.self_intersections, 0);
    EXPECT_EQ(drape.inverted_triangles, 0);
    gaps = outside(garment, drape.positions);
    EXPECT_GT(gaps.size(), 60u);
    for (const double gap : gaps) EXPECT_GT(gap, 0);
  }
}

TEST(Layers, AnApronHasNoOpening) {
  Pattern pattern = skirt_and_overskirt();
  pattern.seams.erase(pattern.seams.begin() + 4, pattern.seams.begin() + 6);  // the overskirt's sides
  pattern.seams.pop_back();
  pattern.pieces.pop_back();
  const GarmentMesh garment = sewn(pattern);
  const Dressed dressed = dress(pattern, garment, figure_body());
  EXPECT_TRUE(dressed.report.ok()) << in_words(dressed.report.findings.at(0));
  EXPECT_EQ(dressed.openings.size(), 2u);
}

TEST(FlatLayers, ReachPastWhatIsUnderThemAndStandOutsideIt) {
  Eigen::Matrix3Xd inner(3, 4), outer(3, 4), half(3, 2);
  inner << -.3, .3, .3, -.3, .5, .5, 1, 1, .2, .2, .2, .2;
  outer << -.25, .25, .25, -.25, .5, .5, 1, 1, .1, .1, .1, .1;
  const double wider = widening({&inner}, {&outer});
  EXPECT_GT(wider * .25, .3);
  widen(wider, outer);
  EXPECT_NEAR(outer(0, 1), wider * .25, 1e-12);
  EXPECT_NEAR(outer(0, 0), -wider * .25, 1e-12);
  move_outside(inner, Eigen::Vector3d::UnitZ(), outer);
  EXPECT_GT(outer.row(2).minCoeff(), inner.row(2).maxCoeff());
  half << 0, .25, 1, 1, 0, 0;  // goes a little across the middle
  widen(1.2, half);
  EXPECT_LT(half(0, 0), 0);
  EXPECT_NEAR(half(0, 1), .3, 1e-12);
  // Beside each other nothing moves.
  Eigen::Matrix3Xd below = outer;
  below.row(1).array() -= 2;
  const Eigen::Matrix3Xd before = below;
  move_outside(inner, Eigen::Vector3d::UnitZ(), below);
  EXPECT_EQ(below, before);
  EXPECT_EQ(widening({&inner}, {&below}), 1);
}

TEST(Stitches, OfAnOuterLayerWaitForThoseUnderIt) {
  LoosePanels cloth;
  cloth.positions.resize(3, 3);
  cloth.positions << 0, .2, 1, 0, 0, 0, 0, 0, 0;
  cloth.stitched = {{0, 1, 2}};
  cloth.layer = {0, 0, 1};
  Stitches stitches(cloth, 10);
  EXPECT_EQ(stitches.layers(), 2);
  Eigen::Matrix3Xd x = cloth.positions;
  for (int step = 0; step < 10; ++step) {
    stitches.begin(step, x);
    stitches.pull(x);
  }
  EXPECT_NEAR(x(0, 0), .1, 1e-12);
  EXPECT_NEAR(x(0, 1), .1, 1e-12);
  EXPECT_EQ(x(0, 2), 1);
  double before = 1;
  for (int step = 10; step < 20; ++step) {
    stitches.begin(step, x);
    EXPECT_TRUE(stitches.outermost());
    stitches.pull(x);
    EXPECT_LT(x(0, 2), before);
    before = x(0, 2);
  }
  EXPECT_NEAR(x(0, 2), .1, 1e-12);
}

// A band with two strips below it, flat on each other.
GarmentMesh flat_strips(bool layered) {
  Pattern pattern;
  pattern.pieces = {rectangle("band", .3, .1, {0, .2}), rectangle("skirt", .3, .2), rectangle("over", .3, .1, {0, .1})};
  pattern.seams = {{"1", span("band", 1, "bottom"), span("skirt", 1, "top", 1, 0), false},
                   {"2", span("band", 1, "bottom"), span("over", 1, "top", 1, 0), false}};
  if (!layered) pattern.seams.clear();
  return sewn(pattern);
}

TEST(Hinges, OfLayersAreFlatWhenTheyAre) {
  const GarmentMesh garment = flat_strips(true);
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
  for (std::size_t p = 0; p < 3; ++p)
    for (Eigen::Index v = 0; v < garment.welded[p].size(); ++v)
      x.col(garment.welded[p](v)).head<2>() = garment.panels[p].rest.col(v);
  int across = 0;
  for (const fem::Hinge& hinge : fem::bending_hinges(garment, Fabric{})) {
    EXPECT_LT(fem::hinge_vector(hinge, x).norm(), 1e-9);
    across += std::abs(x(1, hinge.vertex[0]) - .2) + std::abs(x(1, hinge.vertex[1]) - .2) < 1e-9;
  }
  // The band goes on into both.
  const auto& boundary = garment.panels[0].boundary;
  EXPECT_EQ(across, 2 * std::count_if(boundary.begin(), boundary.end(), [](const auto& v) { return v.edge == 0; }));
}

TEST(MassSpring, OfLayersTouchesTheBodyWithTheAreaOfEachPanel) {
  double sum[2] = {0, 0};
  for (const bool layered : {false, true})
    for (const auto& sample : mass_spring::make_cloth(flat_strips(layered), Fabric{}, figure_body()).samples)
      sum[layered] += sample.area;
  EXPECT_NEAR(sum[1], sum[0], 1e-12);
}

}  // namespace
}  // namespace toile::test
