#pragma once
// One iteration of the style energy after the other, under one set of constraints.

#include <vector>

#include "style/style_solve.h"
#include "style/style_system.h"

namespace toile {

// The shape at one time of a solve, and what its triangles are drawn to.
class StyleIteration {
 public:
  // Keeps references. Starts at `initial`, whose in-plane maps are those that the pull is towards.
  StyleIteration(const std::vector<SourceTriangle>& triangles, StyleSystem& system, const Eigen::Matrix3Xd& initial,
                 const StyleOptions& options);

  const Eigen::Matrix3Xd& x() const { return x_; }
  void go_to(const Eigen::Matrix3Xd& x) { x_ = x; }

  // One step with the soft terms that the system is factored with; the largest move, m.
  double step();
  // One step to where those steps lead to at last, but for triangles whose stretch is at its bounds, in balance with `force`
  // (3 x n); the largest move, m.
  double step_directly(const std::vector<SoftTerm>& soft, const Eigen::Matrix3Xd& force);
  // What is out of balance at x() (3 x n): step_directly() with it as force stays there.
  Eigen::Matrix3Xd imbalance(const std::vector<SoftTerm>& soft) const;

 private:
  struct MapBounds {
    double least, most;
  };
  Eigen::Matrix2d drawn_to(std::size_t t) const;
  double move_to(const Eigen::Matrix3Xd& next);

  const std::vector<SourceTriangle>& triangles_;
  StyleSystem& system_;
  const StyleOptions& options_;
  Eigen::Matrix3Xd x_;
  std::vector<Eigen::Matrix2d> maps_, first_;
  std::vector<MapBounds> bounds_;
};

}  // namespace toile
