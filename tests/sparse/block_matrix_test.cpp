#include "sparse/block_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <set>
#include <stdexcept>

namespace toile {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

// A grid of vertices with one diagonal a cell, closed to a tube along x.
Pairs tube(int columns, int rows) {
  Pairs pairs;
  const auto id = [&](int i, int j) { return j * columns + i % columns; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      pairs.emplace_back(id(i, j), id(i + 1, j));
      if (j + 1 == rows) continue;
      pairs.emplace_back(id(i, j), id(i, j + 1));
      pairs.emplace_back(id(i, j), id(i + 1, j + 1));
    }
  return pairs;
}

// Positive definite, no two blocks alike, none symmetric; the dense matrix beside it.
struct Filled {
  BlockMatrix sparse;
  Eigen::MatrixXd dense;
  Filled(int vertices, const Pairs& pairs) : sparse(vertices, pairs), dense(Eigen::MatrixXd::Zero(3 * vertices, 3 * vertices)) {
    double seed = 0;
    for (const auto& [i, j] : pairs) {
      const Eigen::Matrix3d block = Eigen::Matrix3d::NullaryExpr([&] { return std::sin(seed += 1.7); });
      sparse.add(i, j, block);
      dense.block<3, 3>(3 * i, 3 * j) += block;
      dense.block<3, 3>(3 * j, 3 * i) += block.transpose();
    }
    for (int v = 0; v < vertices; ++v) {
      const double heavy = 25 + v % 3;
      sparse.add_diagonal(v, heavy);
      dense.diagonal().segment<3>(3 * v).array() += heavy;
    }
  }
};

Eigen::Matrix3Xd some_vector(int vertices) {
  return Eigen::Matrix3Xd::NullaryExpr(3, vertices,
                                       [](Eigen::Index r, Eigen::Index c) { return std::cos(2.3 * double(3 * c + r)); });
}

TEST(BlockMatrix, SolvesAsADenseFactorisationDoes) {
  for (const auto& [columns, rows] : {std::pair{5, 1}, {6, 4}, {14, 17}}) {
    const int n = columns * rows;
    Filled matrix(n, tube(columns, rows));
    ASSERT_TRUE(matrix.sparse.factorise());
    const Eigen::Matrix3Xd b = some_vector(n);
    const Eigen::VectorXd expected = matrix.dense.llt().solve(Eigen::Map<const Eigen::VectorXd>(b.data(), 3 * n));
    const Eigen::Matrix3Xd y = matrix.sparse.solve(b);
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(y.data(), 3 * n) - expected).cwiseAbs().maxCoeff(), 1e-12) << n;
  }
}

TEST(BlockMatrix, MultipliesAsTheDenseMatrixDoes) {
  const int n = 9 * 8;
  const Filled matrix(n, tube(9, 8));
  const Eigen::Matrix3Xd y = some_vector(n);
  const Eigen::VectorXd expected = matrix.dense * Eigen::Map<const Eigen::VectorXd>(y.data(), 3 * n);
  const Eigen::Matrix3Xd product = matrix.sparse.multiply(y);
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(product.data(), 3 * n) - expected).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BlockMatrix, TakesPartsThatHaveNothingToDoWithEachOther) {
  Pairs pairs = tube(5, 3);
  for (const auto& [i, j] : tube(4, 4)) pairs.emplace_back(15 + i, 15 + j);
  Filled matrix(32, pairs);  // the last vertex is alone
  ASSERT_TRUE(matrix.sparse.factorise());
  const Eigen::Matrix3Xd b = some_vector(32);
  EXPECT_LT((matrix.sparse.multiply(matrix.sparse.solve(b)) - b).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(BlockMatrix, GivesTheSameBytesTwiceAndAfterOtherValues) {
  const int n = 14 * 17;
  Filled matrix(n, tube(14, 17)), other(n, tube(14, 17));
  const Eigen::Matrix3Xd b = some_vector(n);
  ASSERT_TRUE(matrix.sparse.factorise());
  const Eigen::Matrix3Xd first = matrix.sparse.solve(b);
  for (int v = 0; v < n; ++v) other.sparse.add_diagonal(v, v);
  ASSERT_TRUE(other.sparse.factorise());
  EXPECT_NE(other.sparse.solve(b), first);
  other.sparse.values() = matrix.sparse.values();
  ASSERT_TRUE(other.sparse.factorise());
  EXPECT_EQ(other.sparse.solve(b), first);
  EXPECT_EQ(matrix.sparse.solve(b), first);
}

TEST(BlockMatrix, SaysThatAMatrixIsNotPositiveDefinite) {
  Filled matrix(20, tube(5, 4));
  matrix.sparse.add_diagonal(13, -60);
  EXPECT_FALSE(matrix.sparse.factorise());
}

// Nothing holds the tube: its Laplacian is singular, and near it once something weak does.
TEST(BlockMatrix, KnowsHowNearToSingularItIs) {
  BlockMatrix matrix(20, tube(5, 4));
  for (const auto& [i, j] : tube(5, 4)) {
    matrix.add(i, j, -Eigen::Matrix3d::Identity());
    matrix.add_diagonal(i, 1);
    matrix.add_diagonal(j, 1);
  }
  EXPECT_TRUE(!matrix.factorise() || matrix.pivot_ratio() < 1e-13);
  matrix.add_diagonal(0, 1e-6);
  ASSERT_TRUE(matrix.factorise());
  EXPECT_GT(matrix.pivot_ratio(), 1e-9);
  EXPECT_LT(matrix.pivot_ratio(), 1e-6);
}

TEST(BlockMatrix, KnowsItsPattern) {
  BlockMatrix matrix(4, {{2, 0}, {0, 1}, {1, 0}, {3, 3}});
  EXPECT_TRUE(matrix.has(0, 2) && matrix.has(2, 0) && matrix.has(1, 1) && matrix.has(1, 0));
  EXPECT_FALSE(matrix.has(1, 2) || matrix.has(3, 0));
  EXPECT_EQ(matrix.values().size(), 9u * 6);
  std::set<int> places;
  for (const auto& [i, j] : Pairs{{0, 0}, {1, 1}, {2, 2}, {3, 3}, {0, 1}, {0, 2}}) places.insert(matrix.place(i, j));
  EXPECT_EQ(places.size(), 6u);
  EXPECT_EQ(matrix.place(0, 2), matrix.place(2, 0));
  EXPECT_THROW(matrix.place(1, 2), std::invalid_argument);
}

}  // namespace
}  // namespace toile
