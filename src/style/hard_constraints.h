#pragma once
// What an edit fixes outright. These degrees of freedom are eliminated, so that they are met exactly.

#include <Eigen/Core>
#include <map>

namespace toile {

// Per vertex x = fixed + free * y: `free` has as many columns as the vertex has freedoms (3, 2 or 0).
struct VertexFreedom {
  Eigen::Vector3d fixed = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> free = Eigen::Matrix3d::Identity();
};

struct HardConstraints {
  std::map<int, VertexFreedom> vertices;  // those not listed are free

  void hold(int vertex, const Eigen::Vector3d& at);
  // Keeps `axis` . x at `coordinate` and leaves the vertex free across the axis (unit).
  void hold_along(int vertex, const Eigen::Vector3d& axis, double coordinate);
};

}  // namespace toile
