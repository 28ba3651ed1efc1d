#pragma once
// Symmetric 3x3-block matrix with a fixed pattern and its Cholesky factor: multifrontal (Liu 1992, The multifrontal method for
// sparse matrix solution) on the supernodes of elimination.h, dense parts by BLAS. Branches of the elimination are worked on
// by several threads; every sum has its own fixed order, so that the same input gives the same bytes on any number of them.

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

namespace toile {

class BlockMatrix {
 public:
  // `pairs`: vertex pairs that share a block; the diagonal is always there.
  BlockMatrix(int vertices, std::vector<std::pair<int, int>> pairs);
  ~BlockMatrix();
  BlockMatrix(const BlockMatrix&) = delete;
  BlockMatrix& operator=(const BlockMatrix&) = delete;

  bool has(int i, int j) const;
  // Where in values() the block of this pair begins: nine numbers, rows max(i, j), columns min(i, j), column after column.
  // Throws std::invalid_argument when the pair is not in the pattern.
  int place(int i, int j) const;
  // Adds the block of rows `i`, columns `j`; of a symmetric pair give one of (i, j), (j, i). The pair must be in the pattern.
  void add(int i, int j, const Eigen::Matrix3d& block);
  void add_diagonal(int i, double value);

  std::vector<double>& values();
  const std::vector<double>& values() const;

  // False when the matrix is not positive definite (to working precision).
  bool factorise();
  // Smallest over largest squared pivot of the last factorisation, unknowns one by one; about 1e-16 when the matrix is
  // singular.
  double pivot_ratio() const;
  // Solution of A y = b with the last factorisation; b and y are 3 x vertices.
  Eigen::Matrix3Xd solve(const Eigen::Matrix3Xd& b) const;
  Eigen::Matrix3Xd multiply(const Eigen::Matrix3Xd& y) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toile
