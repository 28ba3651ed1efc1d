#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "garment/welds.h"
#include "geometry/topology.h"
#include "triangulate/expect_code.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile {
namespace {

GarmentMesh sewn(const Pattern& pattern, double edge_length = 15e-3) {
  return sew(pattern, triangulate(pattern, {edge_length, 20}));
}

int euler(const GarmentMesh& garment) {
  return garment.vertex_count - static_cast<int>(mesh_edges(garment.triangles).size()) + triangle_count(garment);
}

std::size_t holes(const GarmentMesh& garment) { return boundary_loops(garment.triangles).size(); }

TEST(Sew, MakesARingOfTheGoredSkirt) {
  for (const double h : {.06, .03, .015}) {
    const GarmentMesh garment = sewn(gored_skirt(), h);
    EXPECT_EQ(euler(garment), 0);
    EXPECT_EQ(holes(garment), 2u);
    EXPECT_NO_THROW(check(garment));
  }
}

TEST(Sew, ClosesADart) {
  const GarmentMesh garment = sewn(darted_panel());
  EXPECT_EQ(euler(garment), 1);
  EXPECT_EQ(holes(garment), 1u);
  EXPECT_LT(garment.vertex_count, static_cast<int>(garment.panels[0].rest.cols()));
}

TEST(Sew, JoinsAMirroredPair) {
  const GarmentMesh garment = sewn(mirrored_fronts());
  EXPECT_EQ(euler(garment), 1);
  EXPECT_EQ(holes(garment), 1u);
}

TEST(Sew, JoinsSidesOfDifferentLength) {
  for (const double ratio : {1.0, 1.2, 2.6}) {
    EXPECT_EQ(euler(sewn(eased_seam(ratio))), 1);
    EXPECT_EQ(euler(sewn(eased_seam(1 / ratio))), 1);
  }
}

// Two panels sewn all round stay a surface however coarse: no chord of one may fall on a chord of the other.
TEST(Sew, MakesAClosedSurfaceOfTwoPanelsSewnAllRound) {
  Pattern pillow;
  Piece piece = polygon_piece("p", {{0, 0}, {.3, 0}, {.35, .2}, {.1, .3}});
  piece.mirrored_quantity = 1;
  pillow.pieces = {piece};
  for (const Edge& edge : piece.outline) pillow.seams.push_back({edge.id, span("p", 1, edge.id), span("p", 2, edge.id), false});
  for (const double h : {1., .2, .1, .05, .02}) {
    const GarmentMesh garment = sewn(pillow, h);
    EXPECT_EQ(euler(garment), 2) << h;
    EXPECT_TRUE(defects_of_closed_surface(garment.triangles).empty()) << h;
  }
}

TEST(Sew, RollsAStripIntoARing) {
  Pattern cuff;
  cuff.pieces = {rectangle("cuff", .2, .06)};
  cuff.seams = {{"close", span("cuff", 1, "right"), span("cuff", 1, "left", 1, 0), false}};
  for (const double h : {.5, .1, .015}) {
    EXPECT_EQ(euler(sewn(cuff, h)), 0) << h;
    EXPECT_EQ(holes(sewn(cuff, h)), 2u) << h;
  }
}

// The disc has one edge, which starts and ends at its only turn point.
TEST(Sew, ClosesATubeWithADisc) {
  const double radius = .08;
  Piece disc;
  disc.name = "disc";
  disc.outline = {arc_edge("rim", {radius, 0}, {-radius, 1e-17}, {0, 0}, 60)};
  for (int i = 1; i <= 60; ++i) {
    const double angle = std::numbers::pi * (1 + i / 60.);
    disc.outline[0].points.push_back({radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)), i == 60, {}});
  }
  disc.outline[0].points.back().at = disc.outline[0].points.front().at;
  Pattern bag;
  bag.pieces = {rectangle("tube", .5, .1), disc};
  bag.seams = {{"side", span("tube", 1, "right"), span("tube", 1, "left", 1, 0), false},
               {"base", span("tube", 1, "bottom"), span("disc", 1, "rim", 1, 0), false}};
  for (const double h : {.2, .05, .015}) {
    const GarmentMesh garment = sewn(bag, h);
    EXPECT_EQ(euler(garment), 1) << h;
    EXPECT_EQ(holes(garment), 1u) << h;
  }
}

TEST(Sew, FoldsAnEdgeOntoItself) {
  Pattern pattern;
  pattern.pieces = {rectangle("pocket", .2, .15)};
  pattern.seams = {{"top", span("pocket", 1, "top", 0, .5), span("pocket", 1, "top", 1, .5), false}};
  const GarmentMesh garment = sewn(pattern);
  EXPECT_EQ(euler(garment), 1);
  EXPECT_EQ(holes(garment), 1u);
}

TEST(Sew, LeavesWhatIsNotSewnOpen) {
  Pattern skirt = gored_skirt();
  std::erase_if(skirt.seams, [](const Seam& seam) { return seam.name == "band" || seam.name == "side 8"; });
  const GarmentMesh garment = sewn(skirt);
  EXPECT_EQ(euler(garment), 1);
  EXPECT_EQ(holes(garment), 1u);
}

TEST(Sew, WeldsVerticesAtTheSameFraction) {
  const Pattern skirt = gored_skirt();
  const GarmentMesh garment = sewn(skirt);
  std::vector<double> right(static_cast<std::size_t>(garment.vertex_count), -1);
  for (const BoundaryVertex& v : garment.panels[0].boundary)
    if (v.edge == 1) right[static_cast<std::size_t>(garment.welded[0](v.vertex))] = v.at;
  int met = 0;
  for (const BoundaryVertex& v : garment.panels[1].boundary) {
    const double at = right[static_cast<std::size_t>(garment.welded[1](v.vertex))];
    if (v.edge != 3 || at < 0) continue;
    EXPECT_NEAR(at, 1 - v.at, 1e-12);
    ++met;
  }
  EXPECT_GE(met, 39);
}

TEST(Sew, KeepsTheRightSideOut) {
  for (const Pattern& pattern : {gored_skirt(), darted_panel(), mirrored_fronts()}) {
    const GarmentMesh garment = sewn(pattern);
    EXPECT_NO_THROW(boundary_loops(garment.triangles));  // refuses triangles that face opposite ways
  }
}

TEST(Sew, RefusesATwistedSeamUnlessItIsMeant) {
  Pattern pattern = eased_seam(1);
  std::swap(pattern.seams[0].b.begin, pattern.seams[0].b.end);
  EXPECT_EQ(refusal([&] { sewn(pattern); }).code, "seam.twisted");
  pattern.seams[0].right_to_wrong = true;
  EXPECT_EQ(euler(sewn(pattern)), 1);

  Pattern fronts = mirrored_fronts();
  std::swap(fronts.seams[0].a.begin, fronts.seams[0].a.end);
  EXPECT_EQ(refusal([&] { sewn(fronts); }).code, "seam.twisted");
}

TEST(Sew, JoinsThreeLayersAlongOneLine) {
  Pattern pattern;
  Piece strip = rectangle("strip", .2, .1);
  strip.quantity = 3;
  pattern.pieces = {strip};
  pattern.seams = {{"1", span("strip", 1, "top"), span("strip", 2, "bottom", 1, 0), false},
                   {"2", span("strip", 3, "top"), span("strip", 2, "bottom", 1, 0), false}};
  const GarmentMesh garment = sewn(pattern);
  const PanelMesh& panel = garment.panels[0];
  const auto along = std::count_if(panel.boundary.begin(), panel.boundary.end(), [](const auto& v) { return v.edge == 0; });
  // Every side along the line twice more than once; discs that meet in a line are still a disc.
  EXPECT_EQ(garment.vertex_count, 3 * panel.rest.cols() - 2 * (along + 1));
  int further = 0;
  for (const MeshEdge& edge : mesh_edges(garment.triangles)) further += edge.further != -1;
  EXPECT_EQ(further, along);
  EXPECT_EQ(euler(garment) + further, 1);
  // Closed upon itself so that three panels make a ring.
  pattern.seams = {{"1", span("strip", 1, "top"), span("strip", 2, "bottom", 1, 0), false},
                   {"2", span("strip", 2, "top", 1, 0), span("strip", 3, "bottom"), false},
                   {"3", span("strip", 1, "bottom", 1, 0), span("strip", 3, "top"), false}};
  EXPECT_EQ(euler(sewn(pattern)), 0);
}

// A waistband with a skirt, and a shorter, wider one over it.
TEST(Sew, HangsAnOverskirtIntoTheWaistSeam) {
  Pattern pattern = gored_skirt();
  Piece outer = gore(.72 / 8, 3. / 8, .3);
  outer.name = "outer";
  outer.quantity = 8;
  pattern.pieces.push_back(outer);
  for (int c = 1; c <= 8; ++c) {
    pattern.seams.push_back({"", span("outer", c, "right"), span("outer", c % 8 + 1, "left", 1, 0), false});
    pattern.seams.push_back({"", span("waistband", 1, "bottom", (c - 1) / 8., c / 8.), span("outer", c, "waist", 1, 0), false});
  }
  for (const double h : {.06, .03, .015}) {
    const GarmentMesh garment = sewn(pattern, h);
    EXPECT_EQ(holes(garment), 3u);
    for (const BoundarySegment& segment : boundary_segments(garment)) EXPECT_LE(segment.mates.size(), 2u);
    EXPECT_NO_THROW(check(garment));
  }
}

TEST(Sew, RefusesATwistedThirdLayer) {
  Pattern pattern;
  pattern.pieces = {rectangle("band", .3, .1), rectangle("skirt", .3, .2), rectangle("over", .3, .1)};
  pattern.seams = {{"1", span("band", 1, "bottom"), span("skirt", 1, "top", 1, 0), false},
                   {"2", span("band", 1, "bottom"), span("over", 1, "top"), false}};
  EXPECT_EQ(refusal([&] { sewn(pattern); }).code, "seam.twisted");
  // Laid on the skirt, its wrong side on the skirt's right side, and sewn to that.
  pattern.seams[1] = {"2", span("skirt", 1, "top"), span("over", 1, "top"), true};
  EXPECT_EQ(holes(sewn(pattern)), 2u);
}

TEST(Sew, RefusesPanelsOfAnotherPattern) {
  EXPECT_THROW(sew(gored_skirt(), triangulate(darted_panel())), std::invalid_argument);
  Pattern shorter = eased_seam(1);
  shorter.seams[0].a.end = .5;
  EXPECT_THROW(sew(shorter, triangulate(eased_seam(1))), std::invalid_argument);
}

}  // namespace
}  // namespace toile
