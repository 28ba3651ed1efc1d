#pragma once
// In which order the unknowns of a sparse symmetric system are eliminated: nested dissection (METIS), gathered into supernodes
// that form a forest (CHOLMOD's analysis). Branches that have no vertex in common can be worked on side by side.

#include <utility>
#include <vector>

namespace toile {

// Neighbours in the order that have nearly the same rows in the factor; these rows are a dense panel.
struct Supernode {
  int first = 0, count = 0;    // positions in the order
  std::vector<int> below;      // positions of the further rows of the panel, ascending
  std::vector<int> in_parent;  // by `below`: the row of the parent's panel
  int parent = -1;
};

// One or several supernodes that are worked on in one go: a small branch, or a single one near the root.
struct EliminationTask {
  std::vector<int> supernodes;  // children first
  std::vector<int> children;    // tasks that come before
  int parent = -1;
};

struct Elimination {
  std::vector<int> position;          // by vertex
  std::vector<Supernode> supernodes;  // children before parents
  std::vector<std::vector<int>> children;
  std::vector<EliminationTask> tasks;  // children before parents
};

// `pairs`: (smaller, larger) vertex, sorted, without repetition.
Elimination plan_elimination(int vertices, const std::vector<std::pair<int, int>>& pairs);

}  // namespace toile
