#include "sparse/elimination.h"

#include <cholmod.h>

#include <algorithm>
#include <stdexcept>

namespace toile {
namespace {

constexpr double smallest_share = 1 / 24.0;  // of the whole work, that a branch must have to be split into several tasks

// CHOLMOD's workspace and its factor, which holds the order and the supernodes.
struct Analysis {
  cholmod_common common{};
  cholmod_factor* factor = nullptr;

  Analysis() {
    cholmod_start(&common);
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_METIS;
    common.postorder = 1;
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nrelax[0] = 4;  // vertices, of three unknowns each
    common.nrelax[1] = 8;
    common.nrelax[2] = 16;
    common.print = 0;
    common.error_handler = nullptr;
  }
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;
  ~Analysis() {
    if (factor) cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }
};

std::vector<Supernode> supernodes_of(const cholmod_factor& factor) {
  const int* first = static_cast<const int*>(factor.super);
  const int* rows_begin = static_cast<const int*>(factor.pi);
  const int* rows = static_cast<const int*>(factor.s);
  std::vector<Supernode> supernodes(factor.nsuper);
  std::vector<int> of(factor.n);
  for (std::size_t s = 0; s < supernodes.size(); ++s) {
    supernodes[s].first = first[s];
    supernodes[s].count = first[s + 1] - first[s];
    supernodes[s].below.assign(rows + rows_begin[s] + supernodes[s].count, rows + rows_begin[s + 1]);
    for (int column = first[s]; column < first[s + 1]; ++column) of[static_cast<std::size_t>(column)] = static_cast<int>(s);
  }
  for (Supernode& node : supernodes) {
    if (node.below.empty()) continue;
    node.parent = of[static_cast<std::size_t>(node.below.front())];
    const Supernode& parent = supernodes[static_cast<std::size_t>(node.parent)];
    for (const int row : node.below)
      node.in_parent.push_back(
          row < parent.first + parent.count
              ? row - parent.first
              : parent.count +
                    static_cast<int>(std::lower_bound(parent.below.begin(), parent.below.end(), row) - parent.below.begin()));
  }
  return supernodes;
}

// Branches of little work become one task each.
std::vector<EliminationTask> tasks_of(const std::vector<Supernode>& supernodes) {
  const std::size_t n = supernodes.size();
  std::vector<double> branch(n);  // work of a supernode and all below it
  double whole = 0;
  for (std::size_t s = 0; s < n; ++s) {
    const double columns = supernodes[s].count, rows = columns + static_cast<double>(supernodes[s].below.size());
    const double work = columns * rows * rows;
    branch[s] += work;
    whole += work;
    if (supernodes[s].parent >= 0) branch[static_cast<std::size_t>(supernodes[s].parent)] += branch[s];
  }
  std::vector<int> root(n), task(n);
  for (std::size_t s = n; s-- > 0;) {
    const int parent = supernodes[s].parent;
    const bool within = parent >= 0 && branch[static_cast<std::size_t>(parent)] <= smallest_share * whole;
    root[s] = within ? root[static_cast<std::size_t>(parent)] : static_cast<int>(s);
  }
  std::vector<EliminationTask> tasks;
  for (std::size_t s = 0; s < n; ++s)
    if (root[s] == static_cast<int>(s)) {
      task[s] = static_cast<int>(tasks.size());
      tasks.emplace_back();
    }
  for (std::size_t s = 0; s < n; ++s) {
    const int mine = task[static_cast<std::size_t>(root[s])];
    tasks[static_cast<std::size_t>(mine)].supernodes.push_back(static_cast<int>(s));
    const int parent = supernodes[s].parent;
    if (root[s] != static_cast<int>(s) || parent < 0) continue;
    const int next = task[static_cast<std::size_t>(root[static_cast<std::size_t>(parent)])];
    tasks[static_cast<std::size_t>(mine)].parent = next;
    tasks[static_cast<std::size_t>(next)].children.push_back(mine);
  }
  return tasks;
}

}  // namespace

Elimination plan_elimination(int vertices, const std::vector<std::pair<int, int>>& pairs) {
  std::vector<int> column(static_cast<std::size_t>(vertices) + 1), row;
  std::size_t next = 0;
  for (int j = 0; j < vertices; ++j) {
    row.push_back(j);
    for (; next < pairs.size() && pairs[next].first == j; ++next) row.push_back(pairs[next].second);
    column[static_cast<std::size_t>(j) + 1] = static_cast<int>(row.size());
  }
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(vertices);
  matrix.nzmax = row.size();
  matrix.p = column.data();
  matrix.i = row.data();
  matrix.stype = -1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_PATTERN;
  matrix.dtype = CHOLMOD_DOUBLE;
  matrix.sorted = 1;
  matrix.packed = 1;
  Analysis analysis;
  analysis.factor = cholmod_analyze(&matrix, &analysis.common);
  if (!analysis.factor) throw std::runtime_error("plan_elimination: the matrix could not be analysed (out of memory?)");
  Elimination plan;
  plan.position.resize(static_cast<std::size_t>(vertices));
  const int* order = static_cast<const int*>(analysis.factor->Perm);
  for (int k = 0; k < vertices; ++k) plan.position[static_cast<std::size_t>(order[k])] = k;
  plan.supernodes = supernodes_of(*analysis.factor);
  plan.children.resize(plan.supernodes.size());
  for (std::size_t s = 0; s < plan.supernodes.size(); ++s)
    if (plan.supernodes[s].parent >= 0)
      plan.children[static_cast<std::size_t>(plan.supernodes[s].parent)].push_back(static_cast<int>(s));
  plan.tasks = tasks_of(plan.supernodes);
  return plan;
}

}  // namespace toile
