#pragma once
// Anderson acceleration of a fixed-point iteration (Walker and Ni 2011; for local/global solvers Peng et al. 2018).

#include <Eigen/Core>
#include <deque>

namespace toile {

class FixedPointMemory {
 public:
  explicit FixedPointMemory(std::size_t window) : window_(window) {}

  // The next iterate after `at` was mapped to `mapped`: the combination of the remembered images whose step is smallest.
  Eigen::Matrix2Xd next(const Eigen::Matrix2Xd& at, const Eigen::Matrix2Xd& mapped);
  void forget();

 private:
  std::size_t window_;
  Eigen::Matrix2Xd last_step_, last_mapped_;
  std::deque<Eigen::Matrix2Xd> step_changes_, mapped_changes_;
};

}  // namespace toile
