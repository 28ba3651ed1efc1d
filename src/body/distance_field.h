#pragma once
// Signed distance to a body on a grid, smooth enough for Newton's method: a cubic B-spline through exact samples.

#include <Eigen/Core>
#include <memory>

namespace toile {

struct DistanceSample {
  double distance = 0;  // m, negative inside
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();   // of the spline itself, not normalised
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();
};

// Immutable and cheap to copy. C2 within `band` of the surface and a little beyond; farther off, inside the grid, the value is
// interpolated from exact distances four cells apart; outside the grid it is an upper bound that grows outwards. Where parts of
// the surface overlap the union is the body. Queries may run in several threads.
class DistanceField {
 public:
  DistanceField() = default;
  // `triangles` closed and oriented outwards; throws std::invalid_argument otherwise.
  DistanceField(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, double cell = 6e-3, double band = 40e-3);

  double distance(const Eigen::Vector3d& at) const;
  DistanceSample sample(const Eigen::Vector3d& at) const;  // with first and second derivatives
  double band() const;

 private:
  struct Grid;
  std::shared_ptr<const Grid> grid_;
};

}  // namespace toile
