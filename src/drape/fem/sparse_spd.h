#pragma once
// Symmetric 3x3-block matrix with a fixed pattern, factorised by CHOLMOD (supernodal, nested dissection order, one BLAS thread
// so that the same input gives the same bytes).

#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

namespace toile::fem {

class BlockMatrix {
 public:
  // `pairs`: vertex pairs that share a block; the diagonal is always there.
  BlockMatrix(int vertices, std::vector<std::pair<int, int>> pairs);
  ~BlockMatrix();
  BlockMatrix(const BlockMatrix&) = delete;
  BlockMatrix& operator=(const BlockMatrix&) = delete;

  bool has(int i, int j) const;
  void set_zero();
  // Adds the block of rows `i`, columns `j`; of a symmetric pair give one of (i, j), (j, i). The pair must be in the pattern.
  void add(int i, int j, const Eigen::Matrix3d& block);
  void add_diagonal(int i, double value);

  // The values, so that a constant part can be kept and put back.
  const std::vector<double>& values() const;
  void set_values(const std::vector<double>& values);

  // False when the matrix is not positive definite (to working precision).
  bool factorise();
  // Solution of A y = b with the last factorisation; b and y are 3 x vertices.
  Eigen::Matrix3Xd solve(const Eigen::Matrix3Xd& b) const;
  Eigen::Matrix3Xd multiply(const Eigen::Matrix3Xd& y) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toile::fem
