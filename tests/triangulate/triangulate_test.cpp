#include "triangulate/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "geometry/polyline.h"
#include "geometry/topology.h"
#include "triangulate/expect_code.h"
#include "triangulate/sample_patterns.h"

namespace toile {
namespace {

double area(const PanelMesh& panel) {
  double sum = 0;
  for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
    const Eigen::Vector2d a = panel.rest.col(panel.triangles(0, t));
    const Eigen::Vector2d u = panel.rest.col(panel.triangles(1, t)) - a, v = panel.rest.col(panel.triangles(2, t)) - a;
    sum += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  return sum;
}

TEST(Triangulate, CoversThePiece) {
  const Pattern skirt = gored_skirt();
  const auto panels = triangulate(skirt);
  ASSERT_EQ(panels.size(), 9u);
  EXPECT_NEAR(area(panels[8]), signed_area(skirt.pieces[1]), 1e-15);
  EXPECT_NEAR(area(panels[0]), signed_area(skirt.pieces[0]), 1e-3 * signed_area(skirt.pieces[0]));
  EXPECT_NEAR(area(triangulate(darted_panel())[0]), signed_area(darted_panel().pieces[0]), 1e-15);
}

TEST(Triangulate, NamesPanelsByPieceAndCopy) {
  const auto panels = triangulate(gored_skirt());
  EXPECT_EQ(panels[2].name, "gore:3");
  EXPECT_EQ(panels[2].copy, 3);
  EXPECT_EQ(panels[8].name, "waistband");
  EXPECT_EQ(panels[8].piece, 1);
}

TEST(Triangulate, GivesCopiesTheSameMesh) {
  const auto panels = triangulate(gored_skirt());
  for (int c = 2; c <= 8; ++c) {
    PanelMesh copy = panels[static_cast<std::size_t>(c - 1)];
    EXPECT_EQ(copy.copy, c);
    copy.copy = 1;
    copy.name = "gore:1";
    EXPECT_EQ(copy, panels[0]);
  }
}

TEST(Triangulate, TurnsMirroredCopiesOver) {
  const auto panels = triangulate(mirrored_fronts());
  ASSERT_EQ(panels.size(), 2u);
  const PanelMesh& drawn = panels[0];
  const PanelMesh& mirrored = panels[1];
  EXPECT_TRUE(mirrored.mirrored);
  EXPECT_EQ(mirrored.rest.row(0), -drawn.rest.row(0));
  EXPECT_EQ(mirrored.rest.row(1), drawn.rest.row(1));
  EXPECT_NEAR(area(mirrored), area(drawn), 1e-15);
  EXPECT_GT(area(mirrored), 0);
  EXPECT_TRUE(std::equal(drawn.boundary.begin(), drawn.boundary.end(), mirrored.boundary.rbegin(), mirrored.boundary.rend()));
  EXPECT_NEAR(mirrored.warp.x(), -drawn.warp.x(), 1e-15);
}

TEST(Triangulate, TakesTheWarpFromTheGrainLine) {
  Pattern pattern = mirrored_fronts();
  EXPECT_TRUE(triangulate(pattern)[0].warp.isApprox(Eigen::Vector2d(.02, .3).normalized()));
  pattern.pieces[0].grainline.reset();
  EXPECT_EQ(triangulate(pattern)[0].warp, Eigen::Vector2d::UnitY());
}

// The one loop of the mesh is the boundary in its order, counter-clockwise also on the mirrored copy.
TEST(Triangulate, ListsTheWholeBoundaryInOrder) {
  for (const Pattern& pattern : {gored_skirt(), darted_panel(), mirrored_fronts()})
    for (const PanelMesh& panel : triangulate(pattern)) {
      const auto loops = boundary_loops(panel.triangles);
      ASSERT_EQ(loops.size(), 1u);
      std::vector<int> listed;
      for (const BoundaryVertex& v : panel.boundary) listed.push_back(v.vertex);
      std::rotate(listed.begin(), std::min_element(listed.begin(), listed.end()), listed.end());
      EXPECT_EQ(listed, loops[0]);
    }
}

TEST(Triangulate, KnowsThePlaceOfEveryBoundaryVertex) {
  const Pattern pattern = mirrored_fronts();
  for (const PanelMesh& panel : triangulate(pattern))
    for (const BoundaryVertex& v : panel.boundary) {
      EXPECT_GE(v.at, 0);
      EXPECT_LT(v.at, 1);
      Eigen::Vector2d place = point_at<2>(positions(pattern.pieces[0].outline[static_cast<std::size_t>(v.edge)]), v.at);
      if (panel.mirrored) place.x() *= -1;
      EXPECT_LT((panel.rest.col(v.vertex) - place).norm(), 1e-12);
    }
}

TEST(Triangulate, PutsAVertexOnEveryTurnPoint) {
  const Pattern pattern = darted_panel();
  const PanelMesh panel = triangulate(pattern)[0];
  for (const Edge& edge : pattern.pieces[0].outline)
    EXPECT_TRUE(std::any_of(panel.boundary.begin(), panel.boundary.end(), [&](const BoundaryVertex& v) {
      return v.at == 0 && panel.rest.col(v.vertex) == edge.points.front().at;
    })) << edge.id;
}

TEST(Triangulate, GivesTheSameBytesTwice) {
  EXPECT_EQ(triangulate(gored_skirt()), triangulate(gored_skirt()));
  EXPECT_EQ(triangulate(mirrored_fronts()), triangulate(mirrored_fronts()));
}

TEST(Triangulate, FollowsTheEdgeLength) {
  for (const double h : {.03, .015, .008}) {
    const PanelMesh panel = triangulate(mirrored_fronts(), {h, 20})[0];
    double sum = 0;
    const auto edges = mesh_edges(panel.triangles);
    for (const MeshEdge& edge : edges) sum += (panel.rest.col(edge.vertex[0]) - panel.rest.col(edge.vertex[1])).norm();
    EXPECT_NEAR(sum / static_cast<double>(edges.size()) / h, 1, .15) << h;
  }
}

TEST(Triangulate, PassesOnWhatIsWrongWithAPattern) {
  Pattern pattern = gored_skirt();
  pattern.seams[0].a.edge = "side";
  EXPECT_EQ(refusal([&] { triangulate(pattern); }).code, "seam.unknown-edge");
  pattern.pieces[0].outline.pop_back();
  EXPECT_EQ(refusal([&] { triangulate(pattern); }).code, "pattern.open-outline");
  EXPECT_THROW(triangulate(gored_skirt(), {0, 20}), std::invalid_argument);
  EXPECT_EQ(refusal([] { triangulate(gored_skirt(), {15e-6, 20}); }).code, "mesh.edge-length-too-short");
}

TEST(GarmentMesh, IsEqualOnlyToOneOfTheSameSizesAndValues) {
  const Pattern pattern = gored_skirt();
  const GarmentMesh coarse = sew(pattern, triangulate(pattern, {.edge_length = .05}));
  const GarmentMesh fine = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  GarmentMesh moved = coarse;
  moved.panels[0].rest(0, 0) += 1e-9;
  EXPECT_EQ(coarse, GarmentMesh(coarse));
  EXPECT_FALSE(coarse == fine);
  EXPECT_FALSE(coarse == moved);
}

}  // namespace
}  // namespace toile
