#include "collide/near_pairs.h"

#include <gtest/gtest.h>

#include <set>

#include "collide/closest_points.h"
#include "sheets.h"

namespace toile::test {
namespace {

using Key = std::pair<int, std::array<int, 4>>;

std::set<Key> keys(const std::vector<NearPair>& pairs) {
  std::set<Key> all;
  for (const NearPair& pair : pairs) all.insert({pair.first, pair.vertex});
  return all;
}

TEST(NearPairs, AreThoseThatBruteForceFinds) {
  const Sheet cloud = scattered(60, .3, 3);
  const auto& x = cloud.positions;
  const CollisionMesh mesh = collision_mesh(cloud.triangles, static_cast<int>(x.cols()));
  const double distance = .05;
  std::set<Key> expected;
  for (const int v : mesh.corners)
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const Eigen::Vector3i c = mesh.triangles.col(t);
      if ((c.array() == v).any()) continue;
      if (closest_to_triangle(x.col(v), x.col(c(0)), x.col(c(1)), x.col(c(2))).distance < distance)
        expected.insert({1, {v, c(0), c(1), c(2)}});
    }
  for (Eigen::Index e = 0; e < mesh.edges.cols(); ++e)
    for (Eigen::Index f = e + 1; f < mesh.edges.cols(); ++f) {
      const Eigen::Vector2i a = mesh.edges.col(e), b = mesh.edges.col(f);
      if (a(0) == b(0) || a(0) == b(1) || a(1) == b(0) || a(1) == b(1)) continue;
      if (closest_of_segments(x.col(a(0)), x.col(a(1)), x.col(b(0)), x.col(b(1))).distance < distance)
        expected.insert({2, {a(0), a(1), b(0), b(1)}});
    }
  const auto pairs = near_pairs(x, mesh, distance);
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(keys(pairs), expected);
  EXPECT_EQ(pairs.size(), expected.size()) << "each once";
  EXPECT_EQ(keys(near_pairs(x, mesh, distance)), expected);
}

TEST(NearPairs, ASearchOfAMovingClothFindsTheSame) {
  Sheet cloud = scattered(60, .3, 4);
  const CollisionMesh mesh = collision_mesh(cloud.triangles, static_cast<int>(cloud.positions.cols()));
  NearPairSearch search(mesh, .05, .02);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> push(-.006, .006);
  for (int step = 0; step < 20; ++step) {
    const auto found = search.find(cloud.positions);
    const auto anew = near_pairs(cloud.positions, mesh, .05);
    ASSERT_EQ(keys(found), keys(anew)) << step;
    for (std::size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i].vertex, anew[i].vertex);
    for (Eigen::Index i = 0; i < cloud.positions.size(); ++i) cloud.positions(i) += push(random);
  }
}

TEST(NearPairs, AFlatSheetIsNotNearToItself) {
  const Sheet one = sheet(6, .02, 0);
  EXPECT_TRUE(near_pairs(one.positions, collision_mesh(one.triangles, 49), .008).empty());
}

TEST(NearPairs, TellWhereAndHowFar) {
  Sheet two = both(sheet(1, 1, 0), sheet(1, .1, .004));
  two.positions.rightCols(4).topRows(2).array() += .3;
  const auto pairs = near_pairs(two.positions, collision_mesh(two.triangles, 8), .008);
  ASSERT_FALSE(pairs.empty());
  for (const NearPair& pair : pairs) {
    EXPECT_NEAR(pair.distance, .004, 1e-15);
    EXPECT_NEAR(std::abs(pair.normal.z()), 1, 1e-12);
    EXPECT_NEAR(pair.middle.z(), .002, 1e-15);
    const bool first_below = pair.vertex[0] < 4;
    EXPECT_EQ(pair.normal.z() < 0, first_below);
  }
}

TEST(NearPairs, TheTwoSidesOfAStitchAreJoined) {
  // Two squares edge to edge, 1 mm apart, the vertices across from each other stitched.
  Sheet two = both(sheet(1, .02, 0), sheet(1, .02, 0));
  two.positions.rightCols(4).row(0).array() += .021;
  EXPECT_FALSE(near_pairs(two.positions, collision_mesh(two.triangles, 8), .008).empty());
  const std::vector<int> stitched{0, 1, 2, 3, 1, 5, 3, 7};
  EXPECT_TRUE(near_pairs(two.positions, collision_mesh(two.triangles, 8, stitched), .008).empty());
}

}  // namespace
}  // namespace toile::test
