#include "style/hard_constraints.h"

#include <Eigen/Dense>

namespace toile {

void HardConstraints::hold(int vertex, const Eigen::Vector3d& at) {
  vertices[vertex] = {at, Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>(3, 0)};
}

void HardConstraints::hold_along(int vertex, const Eigen::Vector3d& axis, double coordinate) {
  const Eigen::Vector3d across = axis.unitOrthogonal();
  VertexFreedom freedom;
  freedom.fixed = axis * coordinate;
  freedom.free.resize(3, 2);
  freedom.free << across, axis.cross(across);
  vertices[vertex] = freedom;
}

}  // namespace toile
