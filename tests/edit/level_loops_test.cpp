#include "edit/level_loops.h"

#include <gtest/gtest.h>

#include <set>

namespace toile {
namespace {

// A strip of `columns` x `rows` quads cut in two; wrapped round when `closed`.
Eigen::Matrix3Xi strip(int columns, int rows, bool closed) {
  std::vector<Eigen::Vector3i> triangles;
  const int wide = closed ? columns : columns + 1;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const int a = r * wide + c, b = r * wide + (c + 1) % wide;
      triangles.emplace_back(a, a + wide, b);
      triangles.emplace_back(b, a + wide, b + wide);
    }
  Eigen::Matrix3Xi all(3, static_cast<Eigen::Index>(triangles.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t) all.col(static_cast<Eigen::Index>(t)) = triangles[t];
  return all;
}

Eigen::VectorXd by_row(int wide, int rows) {
  Eigen::VectorXd field(wide * rows);
  for (int v = 0; v < wide * rows; ++v) field(v) = v / wide;
  return field;
}

TEST(LevelLoops, TakeTheNearerRowOfATube) {
  const Eigen::Matrix3Xi tube = strip(8, 5, true);
  const LevelMesh mesh = level_mesh(tube);
  for (const double level : {2.3, 1.6}) {
    const LevelLoops found = level_loops(mesh, by_row(8, 6), level);
    ASSERT_EQ(found.closed.size(), 1u);
    EXPECT_EQ(found.open, 0);
    EXPECT_EQ(std::set<int>(found.closed[0].begin(), found.closed[0].end()), (std::set<int>{16, 17, 18, 19, 20, 21, 22, 23}));
  }
}

TEST(LevelLoops, TakeTheSideAskedFor) {
  const Eigen::Matrix3Xi tube = strip(8, 5, true);
  const LevelMesh mesh = level_mesh(tube);
  const LevelLoops before = level_loops(mesh, by_row(8, 6), 2.3, LevelSide::before);
  const LevelLoops after = level_loops(mesh, by_row(8, 6), 2.3, LevelSide::after);
  ASSERT_EQ(before.closed.size(), 1u);
  ASSERT_EQ(after.closed.size(), 1u);
  EXPECT_EQ(before.closed[0].size(), 8u);
  for (const int v : before.closed[0]) EXPECT_EQ(v / 8, 2);
  for (const int v : after.closed[0]) EXPECT_EQ(v / 8, 3);
}

TEST(LevelLoops, CountLinesThatLeaveTheGarment) {
  const Eigen::Matrix3Xi sheet = strip(8, 5, false);
  const LevelLoops found = level_loops(level_mesh(sheet), by_row(9, 6), 2.3);
  EXPECT_TRUE(found.closed.empty());
  EXPECT_EQ(found.open, 1);
}

TEST(LevelLoops, FindEveryClosedLineAndNoVertexTwice) {
  const Eigen::Matrix3Xi tube = strip(12, 10, true);
  Eigen::VectorXd field = by_row(12, 11);
  field(8 * 12 + 3) = 0;  // a dent: one vertex far below its level
  const LevelLoops found = level_loops(level_mesh(tube), field, 4.4);
  ASSERT_EQ(found.closed.size(), 2u);
  for (const VertexLoop& loop : found.closed) EXPECT_EQ(std::set<int>(loop.begin(), loop.end()).size(), loop.size());
}

TEST(LevelLoops, AreNoneBeyondTheField) {
  const Eigen::Matrix3Xi tube = strip(8, 5, true);
  EXPECT_TRUE(level_loops(level_mesh(tube), by_row(8, 6), 7).closed.empty());
}

}  // namespace
}  // namespace toile
