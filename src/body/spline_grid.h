#pragma once
// A cubic B-spline through the samples of a regular grid: C2, with its derivatives.

#include <Eigen/Core>
#include <vector>

#include "body/grid_winding.h"

namespace toile {

struct SplineSample {
  double value = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

class SplineGrid {
 public:
  // `samples` at the nodes of `frame`, x fastest, at least 5 nodes each way. The spline takes these values at the nodes (Unser
  // 1999: recursive prefilter, mirror at the ends); coefficients are kept in single precision.
  SplineGrid(const GridFrame& frame, std::vector<float> samples, int threads);

  // `at` is moved into the box one cell inside the grid when it lies outside.
  double value(const Eigen::Vector3d& at) const;
  SplineSample sample(const Eigen::Vector3d& at) const;

  const GridFrame& frame() const { return frame_; }

 private:
  GridFrame frame_;
  std::vector<float> coefficients_;
};

}  // namespace toile
