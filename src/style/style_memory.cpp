#include "style/style_memory.h"

#include <algorithm>

namespace toile {
namespace {

constexpr std::size_t most_known = 4;

}  // namespace

std::shared_ptr<BlockMatrix> StyleMemory::matrix(int vertices, const std::vector<std::pair<int, int>>& pairs) {
  const auto same = std::find_if(known_.begin(), known_.end(),
                                 [&](const Known& known) { return known.vertices == vertices && known.pairs == pairs; });
  if (same != known_.end()) {
    std::rotate(same, same + 1, known_.end());
    return known_.back().matrix;
  }
  if (known_.size() == most_known) known_.erase(known_.begin());
  known_.push_back({vertices, pairs, std::make_shared<BlockMatrix>(vertices, pairs)});
  return known_.back().matrix;
}

}  // namespace toile
