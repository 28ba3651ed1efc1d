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

void HardConstraints::hold_across(int vertex, const Eigen::Vector3d& at, const Eigen::Vector3d& way) {
  VertexFreedom freedom;
  freedom.fixed = at - way * way.dot(at);
  freedom.free.resize(3, 1);
  freedom.free.col(0) = way;
  vertices[vertex] = freedom;
}

}  // namespace toile
