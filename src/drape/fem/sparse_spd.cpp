#include "drape/fem/sparse_spd.h"

#include <cblas.h>
#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <stdexcept>

namespace toile::fem {
namespace {

// CHOLMOD opens an OpenMP region per supernode: at this size its threads cost more than they bring, and two jobs side by side
// choke each other. Both settings are the calling thread's own.
void run_on_one_thread() {
  openblas_set_num_threads(1);
  omp_set_max_active_levels(0);
}

}  // namespace

// Lower triangle by columns. Column 3j+k holds the rest of the diagonal block (rows k..2), then the blocks below it in order.
struct BlockMatrix::State {
  int vertices = 0;
  std::vector<int> first;  // first below-diagonal block of a block column
  std::vector<int> row;    // block row of each of them
  std::vector<int> column_pointer, row_index;
  std::vector<double> values;
  cholmod_common common{};
  cholmod_sparse matrix{};
  cholmod_factor* factor = nullptr;

  ~State() {
    if (factor) cholmod_free_factor(&factor, &common);
    cholmod_finish(&common);
  }

  std::size_t column_start(int j, int k) const {
    return static_cast<std::size_t>(column_pointer[static_cast<std::size_t>(3 * j + k)]);
  }

  int block_index(int i, int j) const {
    const auto begin = row.begin() + first[static_cast<std::size_t>(j)];
    const auto end = row.begin() + first[static_cast<std::size_t>(j) + 1];
    const auto found = std::lower_bound(begin, end, i);
    if (found == end || *found != i) throw std::invalid_argument("BlockMatrix::add: pair is not in the pattern");
    return static_cast<int>(found - begin);
  }
};

BlockMatrix::BlockMatrix(int vertices, std::vector<std::pair<int, int>> pairs) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.vertices = vertices;
  for (auto& pair : pairs)
    if (pair.first > pair.second) std::swap(pair.first, pair.second);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  s.first.assign(static_cast<std::size_t>(vertices) + 1, 0);
  for (const auto& [column, row] : pairs) {
    if (column == row) continue;
    s.row.push_back(row);
    ++s.first[static_cast<std::size_t>(column) + 1];
  }
  for (std::size_t j = 0; j < static_cast<std::size_t>(vertices); ++j) s.first[j + 1] += s.first[j];
  s.column_pointer.push_back(0);
  for (int j = 0; j < vertices; ++j)
    for (int k = 0; k < 3; ++k) {
      for (int r = k; r < 3; ++r) s.row_index.push_back(3 * j + r);
      for (int b = s.first[static_cast<std::size_t>(j)]; b < s.first[static_cast<std::size_t>(j) + 1]; ++b)
        for (int r = 0; r < 3; ++r) s.row_index.push_back(3 * s.row[static_cast<std::size_t>(b)] + r);
      s.column_pointer.push_back(static_cast<int>(s.row_index.size()));
    }
  s.values.assign(s.row_index.size(), 0.0);

  run_on_one_thread();
  cholmod_start(&s.common);
  s.common.nmethods = 1;
  s.common.method[0].ordering = CHOLMOD_METIS;
  s.common.postorder = 1;
  s.common.supernodal = CHOLMOD_SUPERNODAL;
  s.common.final_ll = 1;
  s.common.print = 0;
  s.common.error_handler = nullptr;
  s.matrix.nrow = s.matrix.ncol = static_cast<std::size_t>(3 * vertices);
  s.matrix.nzmax = s.values.size();
  s.matrix.p = s.column_pointer.data();
  s.matrix.i = s.row_index.data();
  s.matrix.x = s.values.data();
  s.matrix.stype = -1;
  s.matrix.itype = CHOLMOD_INT;
  s.matrix.xtype = CHOLMOD_REAL;
  s.matrix.dtype = CHOLMOD_DOUBLE;
  s.matrix.sorted = 1;
  s.matrix.packed = 1;
  s.factor = cholmod_analyze(&s.matrix, &s.common);
  if (!s.factor) throw std::runtime_error("BlockMatrix: the matrix could not be analysed (out of memory?)");
}

BlockMatrix::~BlockMatrix() = default;

bool BlockMatrix::has(int i, int j) const {
  const auto column = static_cast<std::size_t>(std::min(i, j));
  const auto begin = state_->row.begin();
  return i == j || std::binary_search(begin + state_->first[column], begin + state_->first[column + 1], std::max(i, j));
}

void BlockMatrix::set_zero() { std::fill(state_->values.begin(), state_->values.end(), 0.0); }

void BlockMatrix::add(int i, int j, const Eigen::Matrix3d& block) {
  State& s = *state_;
  if (i == j) {
    for (int k = 0; k < 3; ++k)
      for (int r = k; r < 3; ++r) s.values[s.column_start(j, k) + static_cast<std::size_t>(r - k)] += block(r, k);
    return;
  }
  const bool below = i > j;
  const int column = below ? j : i;
  const int b = s.block_index(below ? i : j, column);
  for (int k = 0; k < 3; ++k) {
    double* value = &s.values[s.column_start(column, k) + static_cast<std::size_t>(3 - k + 3 * b)];
    for (int r = 0; r < 3; ++r) value[r] += below ? block(r, k) : block(k, r);
  }
}

void BlockMatrix::add_diagonal(int i, double value) {
  for (int k = 0; k < 3; ++k) state_->values[state_->column_start(i, k)] += value;
}

const std::vector<double>& BlockMatrix::values() const { return state_->values; }

void BlockMatrix::set_values(const std::vector<double>& values) {
  std::copy(values.begin(), values.end(), state_->values.begin());
}

bool BlockMatrix::factorise() {
  State& s = *state_;
  run_on_one_thread();
  s.common.status = CHOLMOD_OK;
  const int done = cholmod_factorize(&s.matrix, s.factor, &s.common);
  return done && s.common.status == CHOLMOD_OK && s.factor->minor == s.factor->n;
}

Eigen::Matrix3Xd BlockMatrix::solve(const Eigen::Matrix3Xd& b) const {
  State& s = *state_;
  cholmod_dense right{};
  right.nrow = right.d = right.nzmax = static_cast<std::size_t>(b.size());
  right.ncol = 1;
  right.x = const_cast<double*>(b.data());
  right.xtype = CHOLMOD_REAL;
  right.dtype = CHOLMOD_DOUBLE;
  cholmod_dense* y = cholmod_solve(CHOLMOD_A, s.factor, &right, &s.common);
  if (!y) throw std::runtime_error("BlockMatrix::solve: CHOLMOD failed");
  const Eigen::Matrix3Xd solution = Eigen::Map<const Eigen::Matrix3Xd>(static_cast<const double*>(y->x), 3, b.cols());
  cholmod_free_dense(&y, &s.common);
  return solution;
}

Eigen::Matrix3Xd BlockMatrix::multiply(const Eigen::Matrix3Xd& y) const {
  const State& s = *state_;
  Eigen::Matrix3Xd product = Eigen::Matrix3Xd::Zero(3, y.cols());
  const double* in = y.data();
  double* out = product.data();
  for (std::size_t column = 0; column + 1 < s.column_pointer.size(); ++column)
    for (int at = s.column_pointer[column]; at < s.column_pointer[column + 1]; ++at) {
      const auto row = static_cast<std::size_t>(s.row_index[static_cast<std::size_t>(at)]);
      const double value = s.values[static_cast<std::size_t>(at)];
      out[row] += value * in[column];
      if (row != column) out[column] += value * in[row];
    }
  return product;
}

}  // namespace toile::fem
