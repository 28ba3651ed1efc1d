#include "geometry/topology.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <stdexcept>

namespace toile {
namespace {

Eigen::Matrix3Xi triangles_of(const std::vector<std::array<int, 3>>& list) {
  Eigen::Matrix3Xi triangles(3, static_cast<Eigen::Index>(list.size()));
  for (std::size_t t = 0; t < list.size(); ++t)
    triangles.col(static_cast<Eigen::Index>(t)) << list[t][0], list[t][1], list[t][2];
  return triangles;
}

const Eigen::Matrix3Xi tetrahedron = triangles_of({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});

// Columns `0..around` joined end to start when `closed`: a tube, else a strip; vertex (i, j) is j * around + i.
Eigen::Matrix3Xi tube(int around, int along) {
  std::vector<std::array<int, 3>> list;
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < around; ++i) {
      const int next = (i + 1) % around;
      const int a = j * around + i, b = j * around + next, c = (j + 1) * around + next, d = (j + 1) * around + i;
      list.push_back({a, b, c});
      list.push_back({a, c, d});
    }
  return triangles_of(list);
}

TEST(MeshEdges, OfTwoTrianglesAreFiveInOrder) {
  const auto edges = mesh_edges(triangles_of({{0, 1, 2}, {2, 1, 3}}));
  ASSERT_EQ(edges.size(), 5u);
  EXPECT_EQ(edges[0], (MeshEdge{{0, 1}, {0, -1}, {2, -1}}));
  EXPECT_EQ(edges[1], (MeshEdge{{0, 2}, {0, -1}, {1, -1}}));
  EXPECT_EQ(edges[2], (MeshEdge{{1, 2}, {0, 1}, {0, 3}}));
  EXPECT_EQ(edges[3], (MeshEdge{{1, 3}, {1, -1}, {2, -1}}));
  EXPECT_EQ(edges[4], (MeshEdge{{2, 3}, {1, -1}, {1, -1}}));
}

TEST(MeshEdges, FirstTriangleRunsFromTheLowerVertex) {
  for (const MeshEdge& edge : mesh_edges(tetrahedron)) {
    ASSERT_GE(edge.triangle[1], 0);
    bool rising = false;
    for (int corner = 0; corner < 3; ++corner)
      rising |= tetrahedron(corner, edge.triangle[0]) == edge.vertex[0] &&
                tetrahedron((corner + 1) % 3, edge.triangle[0]) == edge.vertex[1];
    EXPECT_TRUE(rising);
  }
}

TEST(MeshEdges, RefuseAThirdTriangle) {
  EXPECT_THROW(mesh_edges(triangles_of({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})), std::invalid_argument);
}

TEST(MeshEdges, SatisfyEulerOnATube) {
  const Eigen::Matrix3Xi triangles = tube(9, 4);
  EXPECT_EQ(9 * 5 - static_cast<int>(mesh_edges(triangles).size()) + static_cast<int>(triangles.cols()), 0);
}

TEST(BoundaryLoops, KeepTheSurfaceOnTheLeft) {
  const auto loops = boundary_loops(triangles_of({{3, 1, 2}, {2, 1, 0}}));
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0], (std::vector<int>{0, 2, 3, 1}));
}

TEST(BoundaryLoops, OfATubeAreItsTwoEnds) {
  const auto loops = boundary_loops(tube(5, 3));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0], (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(loops[1], (std::vector<int>{15, 19, 18, 17, 16}));
}

TEST(BoundaryLoops, OfAClosedSurfaceAreNone) { EXPECT_TRUE(boundary_loops(tetrahedron).empty()); }

TEST(BoundaryLoops, PartWhereTwoPanelsTouchInOneVertex) {
  const auto loops = boundary_loops(triangles_of({{0, 1, 2}, {2, 3, 4}}));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0], (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(loops[1], (std::vector<int>{2, 3, 4}));
}

TEST(BoundaryLoops, DoNotDependOnTheOrderOfTriangles) {
  Eigen::Matrix3Xi triangles = tube(12, 6);
  const auto expected = boundary_loops(triangles);
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    for (Eigen::Index t = triangles.cols() - 1; t > 0; --t) {
      const Eigen::Index other = static_cast<Eigen::Index>(random() % static_cast<unsigned>(t + 1));
      triangles.col(t).swap(triangles.col(other));
    }
    EXPECT_EQ(boundary_loops(triangles), expected);
  }
}

TEST(BoundaryLoops, RefuseTrianglesThatFaceOppositeWays) {
  EXPECT_THROW(boundary_loops(triangles_of({{0, 1, 2}, {1, 2, 3}})), std::invalid_argument);
}

TEST(Components, AreNumberedByTheirSmallestVertex) {
  EXPECT_EQ(components(triangles_of({{5, 3, 6}, {0, 2, 6}}), 7), (std::vector<int>{0, 1, 0, 0, 2, 0, 0}));
  EXPECT_THROW(components(triangles_of({{0, 1, 2}}), 2), std::invalid_argument);
}

TEST(ClosedSurface, HasNoDefects) { EXPECT_TRUE(defects_of_closed_surface(tetrahedron).empty()); }

TEST(ClosedSurface, DefectsAreNamedWithTheirPlace) {
  const auto open = defects_of_closed_surface(tetrahedron.leftCols(3));
  ASSERT_EQ(open.size(), 1u);
  EXPECT_NE(open[0].find("open edges (the border of a hole): 3"), std::string::npos);
  EXPECT_NE(open[0].find("vertices 0 and 2"), std::string::npos);

  Eigen::Matrix3Xi turned = tetrahedron;
  turned.col(0) << 0, 1, 2;
  const auto facing = defects_of_closed_surface(turned);
  ASSERT_EQ(facing.size(), 1u);
  EXPECT_NE(facing[0].find("edges whose two triangles face opposite ways: 3"), std::string::npos);

  Eigen::Matrix3Xi pinched(3, 8);
  pinched << tetrahedron, (tetrahedron.array() + 3).matrix();
  const auto touching = defects_of_closed_surface(pinched);
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_NE(touching[0].find("at vertex 3"), std::string::npos);

  EXPECT_EQ(defects_of_closed_surface(Eigen::Matrix3Xi(3, 0)).size(), 1u);
}

}  // namespace
}  // namespace toile
