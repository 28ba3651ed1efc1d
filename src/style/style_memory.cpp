#include "style/style_memory.h"

#include <algorithm>

namespace toile {
namespace {

constexpr std::size_t most_known = 4;

}  // namespace

bool KeptFactor::factorise() {
  if (matrix_.values() == factored_) return definite_;
  definite_ = matrix_.factorise() && matrix_.pivot_ratio() > 1e-10;
  factored_ = matrix_.values();
  return definite_;
}

std::shared_ptr<KeptFactor> StyleMemory::factor(Use use, int vertices, const std::vector<std::pair<int, int>>& pairs) {
  const auto same = std::find_if(known_.begin(), known_.end(), [&](const Known& known) {
    return known.use == use && known.vertices == vertices && known.pairs == pairs;
  });
  if (same != known_.end()) {
    std::rotate(same, same + 1, known_.end());
    return known_.back().factor;
  }
  if (known_.size() == most_known) known_.erase(known_.begin());
  known_.push_back({use, vertices, pairs, std::make_shared<KeptFactor>(vertices, pairs)});
  return known_.back().factor;
}

}  // namespace toile
