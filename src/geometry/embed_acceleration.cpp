#include "geometry/embed_acceleration.h"

#include <Eigen/Dense>

namespace toile {
namespace {

double dot(const Eigen::Matrix2Xd& a, const Eigen::Matrix2Xd& b) { return a.cwiseProduct(b).sum(); }

}  // namespace

Eigen::Matrix2Xd FixedPointMemory::next(const Eigen::Matrix2Xd& at, const Eigen::Matrix2Xd& mapped) {
  Eigen::Matrix2Xd step = mapped - at;
  if (last_step_.cols() == step.cols()) {
    step_changes_.push_back(step - last_step_);
    mapped_changes_.push_back(mapped - last_mapped_);
    if (step_changes_.size() > window_) {
      step_changes_.pop_front();
      mapped_changes_.pop_front();
    }
  }
  last_step_ = step;
  last_mapped_ = mapped;
  const auto count = static_cast<Eigen::Index>(step_changes_.size());
  if (count == 0) return mapped;
  Eigen::MatrixXd gram(count, count);
  Eigen::VectorXd right(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Matrix2Xd& change = step_changes_[static_cast<std::size_t>(i)];
    right(i) = dot(change, step);
    for (Eigen::Index j = 0; j <= i; ++j) gram(i, j) = gram(j, i) = dot(change, step_changes_[static_cast<std::size_t>(j)]);
  }
  gram.diagonal() *= 1 + 1e-12;
  const Eigen::VectorXd shares = gram.completeOrthogonalDecomposition().solve(right);
  Eigen::Matrix2Xd result = mapped;
  for (Eigen::Index i = 0; i < count; ++i) result -= shares(i) * mapped_changes_[static_cast<std::size_t>(i)];
  return result.allFinite() ? result : mapped;
}

void FixedPointMemory::forget() {
  last_step_.resize(2, 0);
  step_changes_.clear();
  mapped_changes_.clear();
}

}  // namespace toile
