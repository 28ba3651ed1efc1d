#pragma once
// What solves over the same triangles and freedoms have in common: the order of elimination, its storage and the last factor.

#include <memory>
#include <utility>
#include <vector>

#include "sparse/block_matrix.h"

namespace toile {

// A matrix with its factor, which is only made anew when a value has changed.
class KeptFactor {
 public:
  KeptFactor(int vertices, const std::vector<std::pair<int, int>>& pairs) : matrix_(vertices, pairs) {}

  const BlockMatrix& matrix() const { return matrix_; }
  // The matrix, to be filled before factorise().
  BlockMatrix& fill() { return matrix_; }
  // False when it is not positive definite or so near to singular that solutions mean nothing.
  bool factorise();

 private:
  BlockMatrix matrix_;
  std::vector<double> factored_;  // values of the last factorisation
  bool definite_ = false;
};

// For one solve after another, not for several at a time. Only saves work: the same bytes come out without it.
class StyleMemory {
 public:
  enum class Use { harmonic, direct };
  // A matrix of this pattern, its values as they were left.
  std::shared_ptr<KeptFactor> factor(Use use, int vertices, const std::vector<std::pair<int, int>>& pairs);

 private:
  struct Known {
    Use use = Use::harmonic;
    int vertices = 0;
    std::vector<std::pair<int, int>> pairs;
    std::shared_ptr<KeptFactor> factor;
  };
  std::vector<Known> known_;  // the latest last
};

}  // namespace toile
