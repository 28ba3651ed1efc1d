#include "geometry/triangle_shape.h"

#include <Eigen/Dense>
#include <cmath>

namespace toile {

Eigen::Matrix2d triangle_shape(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = c - a;
  const double length = u.norm();
  Eigen::Matrix2d shape;
  shape << length, u.dot(v) / length, 0, u.cross(v).norm() / length;
  return shape;
}

Eigen::Matrix2d triangle_shape(const Eigen::Matrix2d& edges) {
  const double length = edges.col(0).norm();
  Eigen::Matrix2d shape;
  shape << length, edges.col(0).dot(edges.col(1)) / length, 0, edges.determinant() / length;
  return shape;
}

Eigen::Matrix2d next_rest(const Eigen::Matrix2d& rest, const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal) {
  return rest * draped.inverse() * goal;
}

Eigen::Vector2d stretch_values(const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal) {
  const Eigen::Matrix2d map = goal * draped.inverse();
  const double sum = std::hypot(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1));
  const double difference = std::hypot(map(0, 0) - map(1, 1), map(1, 0) + map(0, 1));
  return {(sum + difference) / 2, std::abs(sum - difference) / 2};
}

double stretch_agreement(const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal) {
  const Eigen::Vector2d values = stretch_values(draped, goal);
  return 1 - std::hypot(values(0) - 1, values(1) - 1);
}

double printed_agreement(const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal) {
  return 1 - std::hypot(goal(0, 0) / draped(0, 0) - 1, goal(1, 1) / draped(1, 1) - 1);
}

}  // namespace toile
