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

TEST(MeshEdges, OfThreeTrianglesAtAnEdgeListTheThirdBesideTheFirstAcross) {
  std::vector<MeshEdge> at_edge;
  for (const MeshEdge& edge : mesh_edges(triangles_of({{0, 1, 2}, {1, 0, 3}, {1, 0, 4}})))
    if (edge.vertex == std::array{0, 1}) at_edge.push_back(edge);
  ASSERT_EQ(at_edge.size(), 2u);
  EXPECT_EQ(at_edge[0], (MeshEdge{{0, 1}, {0, 1}, {2, 3}, -1}));
  EXPECT_EQ(at_edge[1], (MeshEdge{{0, 1}, {0, 2}, {2, 4}, 1}));
}

TEST(MeshEdges, OfTwoTrianglesOnEachSidePairThemInTheOrderOfTheirNumbers) {
  std::vector<MeshEdge> at_edge;
  for (const MeshEdge& edge : mesh_edges(triangles_of({{1, 0, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}})))
    if (edge.vertex == std::array{0, 1}) at_edge.push_back(edge);
  ASSERT_EQ(at_edge.size(), 2u);
  EXPECT_EQ(at_edge[0], (MeshEdge{{0, 1}, {1, 0}, {3, 2}, -1}));
  EXPECT_EQ(at_edge[1], (MeshEdge{{0, 1}, {3, 2}, {5, 4}, 2}));
}

TEST(MeshEdges, HaveEverySideOfEveryTriangleNewOnce) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<std::array<int, 3>> list;
    for (int t = 0; t < 1 + trial % 6; ++t) list.push_back(random() % 2 ? std::array{0, 1, t + 2} : std::array{1, 0, t + 2});
    std::multiset<int> found;
    int own = 0;
    for (const MeshEdge& edge : mesh_edges(triangles_of(list))) {
      if (edge.vertex != std::array{0, 1}) continue;
      own += edge.further == -1;
      for (std::size_t side = 0; side < 2; ++side)
        if (is_new(edge, side)) found.insert(edge.triangle[side]);
    }
    EXPECT_EQ(own, 1);
    EXPECT_EQ(found.size(), list.size());
    EXPECT_EQ(std::set<int>(found.begin(), found.end()).size(), list.size());
  }
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

// A strip of quadrilaterals between columns of vertices, each from the first to the second row; `first` runs with it on its
// left.
void add_strip(std::vector<std::array<int, 3>>& list, const std::vector<int>& first, const std::vector<int>& second) {
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    list.push_back({first[i], first[i + 1], second[i + 1]});
    list.push_back({first[i], second[i + 1], second[i]});
  }
}

// `count` numbers from `from` on, then the first again when `closed`.
std::vector<int> row(int from, int count, bool closed) {
  std::vector<int> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(from + i);
  if (closed) numbers.push_back(from);
  return numbers;
}

std::vector<int> reversed(std::vector<int> row) { return {row.rbegin(), row.rend()}; }

TEST(BoundaryLoops, OfASkirtUnderAnOverskirtAreTheWaistAndTwoHems) {
  std::vector<std::array<int, 3>> list;
  const auto waist = row(10, 6, true);
  add_strip(list, waist, row(0, 6, true));                       // the band, up to 0 .. 5
  add_strip(list, reversed(waist), reversed(row(20, 6, true)));  // the skirt
  add_strip(list, reversed(waist), reversed(row(30, 6, true)));  // the overskirt
  const auto loops = boundary_loops(triangles_of(list));
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_EQ(loops[0], (std::vector<int>{0, 5, 4, 3, 2, 1}));
  EXPECT_EQ(loops[1], (std::vector<int>{20, 21, 22, 23, 24, 25}));
  EXPECT_EQ(loops[2], (std::vector<int>{30, 31, 32, 33, 34, 35}));
}

TEST(BoundaryLoops, OfABodiceAndASkirtThatAreBothLinedAreFour) {
  std::vector<std::array<int, 3>> list;
  const auto waist = row(10, 5, true);
  for (const int top : {0, 30}) add_strip(list, waist, row(top, 5, true));
  for (const int hem : {20, 40}) add_strip(list, reversed(waist), reversed(row(hem, 5, true)));
  const auto loops = boundary_loops(triangles_of(list));
  ASSERT_EQ(loops.size(), 4u);
  for (const auto& loop : loops) EXPECT_EQ(loop.size(), 5u);
}

TEST(BoundaryLoops, OfAnApronRunBackAlongTheSeamItHangsFrom) {
  std::vector<std::array<int, 3>> list;
  const auto waist = row(10, 6, true);
  add_strip(list, waist, row(0, 6, true));
  add_strip(list, reversed(waist), reversed(row(20, 6, true)));
  add_strip(list, {13, 12, 11}, {33, 32, 31});
  const auto loops = boundary_loops(triangles_of(list));
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_EQ(loops[2], (std::vector<int>{20, 21, 22, 23, 24, 25}));
  EXPECT_EQ(loops[1], (std::vector<int>{11, 31, 32, 33, 13, 12}));
}

TEST(BoundaryLoops, OfAnOverskirtThatIsOpenInFrontLeaveTheSeamOut) {
  std::vector<std::array<int, 3>> list;
  const auto waist = row(10, 4, true);
  add_strip(list, waist, row(0, 4, true));
  add_strip(list, reversed(waist), reversed(row(20, 4, true)));
  add_strip(list, reversed(waist), reversed(row(30, 5, false)));  // its front edges meet at vertex 10
  const auto loops = boundary_loops(triangles_of(list));
  ASSERT_EQ(loops.size(), 3u);
  EXPECT_EQ(loops[1], (std::vector<int>{10, 30, 31, 32, 33, 34}));
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
