#include "style/source_shape.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace toile {

std::vector<SourceTriangle> source_triangles(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xi& triangles) {
  std::vector<SourceTriangle> found;
  found.reserve(static_cast<std::size_t>(triangles.cols()));
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Vector3d a = source.col(triangles(0, t));
    const Eigen::Vector3d u = source.col(triangles(1, t)) - a;
    const Eigen::Vector3d v = source.col(triangles(2, t)) - a;
    const double twice_area = u.cross(v).norm();
    if (!(twice_area > 1e-9 * std::max(u.squaredNorm(), v.squaredNorm()))) continue;
    SourceTriangle triangle;
    triangle.corners = triangles.col(t);
    triangle.area = twice_area / 2;
    triangle.plane.col(0) = u.normalized();
    triangle.plane.col(1) = (v - triangle.plane.col(0) * triangle.plane.col(0).dot(v)).normalized();
    Eigen::Matrix2d edges;
    edges << triangle.plane.transpose() * u, triangle.plane.transpose() * v;
    const Eigen::Matrix2d inverse = edges.inverse();
    triangle.gradients.row(1) = inverse.row(0);
    triangle.gradients.row(2) = inverse.row(1);
    triangle.gradients.row(0) = -(inverse.row(0) + inverse.row(1));
    found.push_back(triangle);
  }
  return found;
}

Eigen::VectorXd vertex_areas(const std::vector<SourceTriangle>& triangles, Eigen::Index vertex_count) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(vertex_count);
  for (const SourceTriangle& triangle : triangles)
    for (int corner = 0; corner < 3; ++corner) areas(triangle.corners(corner)) += triangle.area / 3;
  return areas;
}

Eigen::Matrix<double, 3, 2> map_of(const SourceTriangle& triangle, const Eigen::Matrix3Xd& x) {
  Eigen::Matrix<double, 3, 2> map = Eigen::Matrix<double, 3, 2>::Zero();
  for (int corner = 0; corner < 3; ++corner) map += x.col(triangle.corners(corner)) * triangle.gradients.row(corner);
  return map;
}

Eigen::Matrix2d plane_map_of(const SourceTriangle& triangle, const Eigen::Matrix3Xd& x) {
  return triangle.plane.transpose() * map_of(triangle, x);
}

Eigen::Vector2d signed_singular_values(const Eigen::Matrix2d& map) {
  const double sum = Eigen::Vector2d(map(0, 0) + map(1, 1), map(1, 0) - map(0, 1)).norm();
  const double difference = Eigen::Vector2d(map(0, 0) - map(1, 1), map(1, 0) + map(0, 1)).norm();
  return {(sum + difference) / 2, (sum - difference) / 2};
}

Eigen::Matrix2d clamped(const Eigen::Matrix2d& map, double least, double most) {
  const Eigen::Vector2d now = signed_singular_values(map);
  if (now(0) <= most && now(1) >= least) return map;
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(map, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix2d u = svd.matrixU();
  Eigen::Vector2d values = svd.singularValues();
  if (u.determinant() * svd.matrixV().determinant() < 0) {
    u.col(1) *= -1;
    values(1) *= -1;
  }
  values = values.cwiseMax(least).cwiseMin(most);
  return u * values.asDiagonal() * svd.matrixV().transpose();
}

double shape_energy(const std::vector<SourceTriangle>& triangles, const std::vector<Eigen::Matrix2d>& maps,
                    const Eigen::Matrix3Xd& x) {
  double energy = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    energy += triangles[t].area * (map_of(triangles[t], x) - triangles[t].plane * maps[t]).squaredNorm();
  return energy;
}

Eigen::Matrix3Xd shape_gradient(const std::vector<SourceTriangle>& triangles, const std::vector<Eigen::Matrix2d>& maps,
                                const Eigen::Matrix3Xd& x) {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, x.cols());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const SourceTriangle& triangle = triangles[t];
    const Eigen::Matrix<double, 3, 2> away = 2 * triangle.area * (map_of(triangle, x) - triangle.plane * maps[t]);
    for (int corner = 0; corner < 3; ++corner)
      gradient.col(triangle.corners(corner)) += away * triangle.gradients.row(corner).transpose();
  }
  return gradient;
}

double tilt_energy(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& x) {
  double energy = 0;
  for (const SourceTriangle& triangle : triangles) {
    const Eigen::Vector3d normal = triangle.plane.col(0).cross(triangle.plane.col(1));
    energy += triangle.area * (normal.transpose() * map_of(triangle, x)).squaredNorm();
  }
  return energy;
}

}  // namespace toile
