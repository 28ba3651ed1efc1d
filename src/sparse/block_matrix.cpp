#include "sparse/block_matrix.h"

#include <cblas.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>

#include "parallel/threads.h"
#include "sparse/elimination.h"

extern "C" void dpotrf_(const char* triangle, const int* n, double* a, const int* lda, int* info);

namespace toile {
namespace {

constexpr std::size_t threaded_solve = 1'000'000;  // numbers of the factor from which starting threads pays in a solve

// Of the matrix, where it goes in a supernode's panel.
struct Entry {
  int value;        // in values
  int row, column;  // unknowns of the panel
  bool transposed;
};

// A supernode's share of the factor, and of the elimination on the way there.
struct Panel {
  int columns = 0, rows = 0;  // unknowns, the rows with those of the columns
  std::vector<Entry> entries;
  std::vector<double> factor;   // rows x columns, column after column; the upper triangle is not used
  std::vector<double> update;   // what it passes on to its parent: (rows - columns)^2, lower triangle
  std::vector<double> passing;  // the same of a right-hand side
  int below() const { return rows - columns; }
};

// Adds what `child` passes on, a matrix of the rows of `to`'s parent.
void take(const Supernode& node, Panel& child, Panel& to) {
  const int n = static_cast<int>(node.in_parent.size());
  const double* from = child.update.data();
  for (int j = 0; j < n; ++j) {
    const int target = 3 * node.in_parent[static_cast<std::size_t>(j)];
    for (int k = 0; k < 3; ++k, from += 3 * n) {
      const int column = target + k;
      double* into =
          column < to.columns
              ? &to.factor[static_cast<std::size_t>(column) * static_cast<std::size_t>(to.rows)]
              : &to.update[static_cast<std::size_t>(column - to.columns) * static_cast<std::size_t>(to.below())] - to.columns;
      for (int i = j; i < n; ++i) {
        double* at = into + 3 * node.in_parent[static_cast<std::size_t>(i)];
        for (int r = 0; r < 3; ++r) at[r] += from[3 * i + r];
      }
    }
  }
}

}  // namespace

struct BlockMatrix::State {
  int vertices = 0;
  std::vector<int> first;      // first below-diagonal block of a block column
  std::vector<int> row;        // block row of each of them
  std::vector<double> values;  // diagonal blocks, then the others
  Elimination plan;
  std::vector<std::vector<int>> upwards, downwards;  // tasks before each task
  std::vector<Panel> panels;
  std::size_t factor_size = 0;  // numbers

  void make_panels();
  bool eliminate(std::size_t s);
  void forward(std::size_t s, double* x);
  void backward(std::size_t s, double* x) const;
};

void BlockMatrix::State::make_panels() {
  panels.resize(plan.supernodes.size());
  std::vector<std::size_t> of(static_cast<std::size_t>(vertices));  // supernode by position
  for (std::size_t s = 0; s < panels.size(); ++s) {
    const Supernode& node = plan.supernodes[s];
    panels[s].columns = 3 * node.count;
    panels[s].rows = panels[s].columns + 3 * static_cast<int>(node.below.size());
    panels[s].factor.resize(static_cast<std::size_t>(panels[s].rows) * static_cast<std::size_t>(panels[s].columns));
    factor_size += panels[s].factor.size();
    panels[s].passing.resize(static_cast<std::size_t>(panels[s].below()));
    for (int k = 0; k < node.count; ++k) of[static_cast<std::size_t>(node.first + k)] = s;
  }
  const auto put = [&](int i, int j, int value) {
    int row_position = plan.position[static_cast<std::size_t>(i)], column_position = plan.position[static_cast<std::size_t>(j)];
    const bool transposed = row_position < column_position;
    if (transposed) std::swap(row_position, column_position);
    const std::size_t s = of[static_cast<std::size_t>(column_position)];
    const Supernode& node = plan.supernodes[s];
    int at = row_position - node.first;
    if (at >= node.count)
      at = node.count +
           static_cast<int>(std::lower_bound(node.below.begin(), node.below.end(), row_position) - node.below.begin());
    panels[s].entries.push_back({value, 3 * at, 3 * (column_position - node.first), transposed});
  };
  for (int j = 0; j < vertices; ++j) {
    put(j, j, 9 * j);
    for (int b = first[static_cast<std::size_t>(j)]; b < first[static_cast<std::size_t>(j) + 1]; ++b)
      put(row[static_cast<std::size_t>(b)], j, 9 * (vertices + b));
  }
  downwards.resize(plan.tasks.size());
  for (std::size_t t = 0; t < plan.tasks.size(); ++t) {
    upwards.push_back(plan.tasks[t].children);
    if (plan.tasks[t].parent >= 0) downwards[t].push_back(plan.tasks[t].parent);
  }
}

// False when the columns are not positive definite.
bool BlockMatrix::State::eliminate(std::size_t s) {
  Panel& panel = panels[s];
  const int below = panel.below();
  const bool leaf = plan.children[s].empty();
  std::fill(panel.factor.begin(), panel.factor.end(), 0.0);
  const std::size_t square = static_cast<std::size_t>(below) * static_cast<std::size_t>(below);
  panel.update.assign(square, 0.0);
  for (const Entry& entry : panel.entries) {
    const double* block = &values[static_cast<std::size_t>(entry.value)];
    double* at = &panel.factor[static_cast<std::size_t>(entry.column) * static_cast<std::size_t>(panel.rows) +
                               static_cast<std::size_t>(entry.row)];
    for (int k = 0; k < 3; ++k, at += panel.rows)
      for (int r = 0; r < 3; ++r) at[r] = entry.transposed ? block[3 * r + k] : block[3 * k + r];
  }
  for (const int c : plan.children[s]) {
    Panel& child = panels[static_cast<std::size_t>(c)];
    take(plan.supernodes[static_cast<std::size_t>(c)], child, panel);
    std::vector<double>().swap(child.update);
  }
  int failed = 0;
  dpotrf_("L", &panel.columns, panel.factor.data(), &panel.rows, &failed);
  if (failed) return false;
  if (below == 0) return true;
  double* lower = panel.factor.data() + panel.columns;
  cblas_dtrsm(CblasColMajor, CblasRight, CblasLower, CblasTrans, CblasNonUnit, below, panel.columns, 1, panel.factor.data(),
              panel.rows, lower, panel.rows);
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, below, panel.columns, -1, lower, panel.rows, leaf ? 0 : 1,
              panel.update.data(), below);
  return true;
}

void BlockMatrix::State::forward(std::size_t s, double* x) {
  Panel& panel = panels[s];
  double* own = x + 3 * plan.supernodes[s].first;
  std::fill(panel.passing.begin(), panel.passing.end(), 0.0);
  for (const int c : plan.children[s]) {
    const Panel& child = panels[static_cast<std::size_t>(c)];
    const auto& in_parent = plan.supernodes[static_cast<std::size_t>(c)].in_parent;
    for (std::size_t i = 0; i < in_parent.size(); ++i) {
      const int target = 3 * in_parent[i];
      double* into = target < panel.columns ? own + target : &panel.passing[static_cast<std::size_t>(target - panel.columns)];
      for (std::size_t r = 0; r < 3; ++r) into[r] += child.passing[3 * i + r];
    }
  }
  cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, panel.columns, panel.factor.data(), panel.rows, own, 1);
  if (panel.below() > 0)
    cblas_dgemv(CblasColMajor, CblasNoTrans, panel.below(), panel.columns, -1, panel.factor.data() + panel.columns, panel.rows,
                own, 1, 1, panel.passing.data(), 1);
}

void BlockMatrix::State::backward(std::size_t s, double* x) const {
  const Panel& panel = panels[s];
  const Supernode& node = plan.supernodes[s];
  double* own = x + 3 * node.first;
  if (!node.below.empty()) {
    Eigen::VectorXd known(panel.below());
    for (std::size_t i = 0; i < node.below.size(); ++i) std::copy_n(x + 3 * node.below[i], 3, known.data() + 3 * i);
    cblas_dgemv(CblasColMajor, CblasTrans, panel.below(), panel.columns, -1, panel.factor.data() + panel.columns, panel.rows,
                known.data(), 1, 1, own, 1);
  }
  cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, panel.columns, panel.factor.data(), panel.rows, own, 1);
}

BlockMatrix::BlockMatrix(int vertices, std::vector<std::pair<int, int>> pairs) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.vertices = vertices;
  for (auto& pair : pairs)
    if (pair.first > pair.second) std::swap(pair.first, pair.second);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::erase_if(pairs, [](const auto& pair) { return pair.first == pair.second; });
  s.first.assign(static_cast<std::size_t>(vertices) + 1, 0);
  for (const auto& [column, row] : pairs) {
    s.row.push_back(row);
    ++s.first[static_cast<std::size_t>(column) + 1];
  }
  for (std::size_t j = 0; j < static_cast<std::size_t>(vertices); ++j) s.first[j + 1] += s.first[j];
  s.values.assign(9 * (static_cast<std::size_t>(vertices) + pairs.size()), 0.0);
  s.plan = plan_elimination(vertices, pairs);
  s.make_panels();
}

BlockMatrix::~BlockMatrix() = default;

bool BlockMatrix::has(int i, int j) const {
  const auto column = static_cast<std::size_t>(std::min(i, j));
  const auto begin = state_->row.begin();
  return i == j || std::binary_search(begin + state_->first[column], begin + state_->first[column + 1], std::max(i, j));
}

int BlockMatrix::place(int i, int j) const {
  if (i == j) return 9 * i;
  const State& s = *state_;
  const auto column = static_cast<std::size_t>(std::min(i, j));
  const auto end = s.row.begin() + s.first[column + 1];
  const auto found = std::lower_bound(s.row.begin() + s.first[column], end, std::max(i, j));
  if (found == end || *found != std::max(i, j)) throw std::invalid_argument("BlockMatrix: pair is not in the pattern");
  return 9 * (s.vertices + static_cast<int>(found - s.row.begin()));
}

void BlockMatrix::add(int i, int j, const Eigen::Matrix3d& block) {
  Eigen::Map<Eigen::Matrix3d> into(&state_->values[static_cast<std::size_t>(place(i, j))]);
  if (i >= j)
    into += block;
  else
    into += block.transpose();
}

void BlockMatrix::add_diagonal(int i, double value) {
  for (int k = 0; k < 3; ++k) state_->values[static_cast<std::size_t>(9 * i + 4 * k)] += value;
}

std::vector<double>& BlockMatrix::values() { return state_->values; }
const std::vector<double>& BlockMatrix::values() const { return state_->values; }

bool BlockMatrix::factorise() {
  State& s = *state_;
  openblas_set_num_threads(1);
  std::atomic<bool> definite = true;
  in_order(s.upwards, [&](int task) {
    for (const int node : s.plan.tasks[static_cast<std::size_t>(task)].supernodes)
      if (!definite || !s.eliminate(static_cast<std::size_t>(node))) {
        definite = false;
        return;
      }
  });
  return definite;
}

double BlockMatrix::pivot_ratio() const {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Panel& panel : state_->panels)
    for (int k = 0; k < panel.columns; ++k) {
      const double pivot = panel.factor[static_cast<std::size_t>(k) * static_cast<std::size_t>(panel.rows + 1)];
      least = std::min(least, pivot * pivot);
      most = std::max(most, pivot * pivot);
    }
  return most > 0 ? least / most : 0;
}

Eigen::Matrix3Xd BlockMatrix::solve(const Eigen::Matrix3Xd& b) const {
  State& s = *state_;
  Eigen::Matrix3Xd x(3, b.cols());
  for (Eigen::Index v = 0; v < b.cols(); ++v) x.col(s.plan.position[static_cast<std::size_t>(v)]) = b.col(v);
  const int threads = s.factor_size < threaded_solve ? 1 : thread_count();
  const auto up = [&](int task) {
    for (const int node : s.plan.tasks[static_cast<std::size_t>(task)].supernodes)
      s.forward(static_cast<std::size_t>(node), x.data());
  };
  const auto down = [&](int task) {
    const auto& nodes = s.plan.tasks[static_cast<std::size_t>(task)].supernodes;
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) s.backward(static_cast<std::size_t>(*node), x.data());
  };
  in_order(s.upwards, up, threads);
  in_order(s.downwards, down, threads);
  Eigen::Matrix3Xd y(3, b.cols());
  for (Eigen::Index v = 0; v < b.cols(); ++v) y.col(v) = x.col(s.plan.position[static_cast<std::size_t>(v)]);
  return y;
}

Eigen::Matrix3Xd BlockMatrix::multiply(const Eigen::Matrix3Xd& y) const {
  const State& s = *state_;
  Eigen::Matrix3Xd product(3, y.cols());
  const auto block = [&](int at) { return Eigen::Map<const Eigen::Matrix3d>(&s.values[static_cast<std::size_t>(at)]); };
  for (int v = 0; v < s.vertices; ++v) product.col(v) = block(9 * v) * y.col(v);
  for (int j = 0; j < s.vertices; ++j)
    for (int b = s.first[static_cast<std::size_t>(j)]; b < s.first[static_cast<std::size_t>(j) + 1]; ++b) {
      const int i = s.row[static_cast<std::size_t>(b)];
      product.col(i) += block(9 * (s.vertices + b)) * y.col(j);
      product.col(j) += block(9 * (s.vertices + b)).transpose() * y.col(i);
    }
  return product;
}

}  // namespace toile
