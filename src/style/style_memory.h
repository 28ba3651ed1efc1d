#pragma once
// What solves over the same triangles and freedoms have in common: the order of elimination and its storage.

#include <memory>
#include <utility>
#include <vector>

#include "sparse/block_matrix.h"

namespace toile {

// For one solve after another, not for several at a time. Only saves work: what is solved for does not depend on it.
class StyleMemory {
 public:
  // A matrix of this pattern, its values as they were left.
  std::shared_ptr<BlockMatrix> matrix(int vertices, const std::vector<std::pair<int, int>>& pairs);

 private:
  struct Known {
    int vertices = 0;
    std::vector<std::pair<int, int>> pairs;
    std::shared_ptr<BlockMatrix> matrix;
  };
  std::vector<Known> known_;  // the latest last
};

}  // namespace toile
