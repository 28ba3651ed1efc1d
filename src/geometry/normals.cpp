#include "geometry/normals.h"

#include <Eigen/Geometry>

namespace toile {

Eigen::Matrix3Xd vertex_normals(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xi& triangles) {
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, x.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Vector3d a = x.col(triangles(0, t)), b = x.col(triangles(1, t)), c = x.col(triangles(2, t));
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    for (int k = 0; k < 3; ++k) normals.col(triangles(k, t)) += normal;
  }
  for (Eigen::Index v = 0; v < normals.cols(); ++v) normals.col(v).normalize();
  return normals;
}

}  // namespace toile
