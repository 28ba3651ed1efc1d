#pragma once
// The cheapest cut between two sets of nodes, exact.

#include <vector>

namespace toile {

struct CutEdge {
  int a = 0, b = 0;  // nodes
  double cost = 0;   // >= 0, of cutting between them
};

// By node: 1 where it is on the side of the sinks. `must`: by node, 0:
// source, 1: sink, -1: free. Costs are compared to a millionth of the dearest. Throws std::invalid_argument for a cost that is
// negative or not finite.
std::vector<int> min_cut(const std::vector<int>& must, const std::vector<CutEdge>& edges);

}  // namespace toile
