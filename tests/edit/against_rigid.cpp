#include "edit/against_rigid.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <set>

#include "edit/as_rigid_as_possible.h"
#include "geometry/topology.h"
#include "style/normal_deviation.h"

namespace toile::testing {
namespace {

// By vertex, radians; none at edges.
Eigen::VectorXd angle_defects(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xi& triangles) {
  Eigen::VectorXd defect = Eigen::VectorXd::Constant(x.cols(), 2 * M_PI);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d a = x.col(triangles(k, t)), u = x.col(triangles((k + 1) % 3, t)) - a,
                            v = x.col(triangles((k + 2) % 3, t)) - a;
      defect(triangles(k, t)) -= std::atan2(u.cross(v).norm(), u.dot(v));
    }
  for (const auto& edge : boundary_loops(triangles))
    for (const int v : edge) defect(v) = 0;
  return defect;
}

ShapeChange change(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& shape) {
  const Eigen::VectorXd before = angle_defects(source, triangles), after = angle_defects(shape, triangles);
  return {normal_deviation(source_triangles(source, triangles), source, shape).mean, (after - before).cwiseAbs().sum(),
          (after.cwiseAbs() - before.cwiseAbs()).cwiseMax(0).sum(), after.cwiseAbs().sum() - before.cwiseAbs().sum()};
}

}  // namespace

AgainstRigid against_rigid(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& style,
                           const std::vector<int>& held) {
  std::set<int> all(held.begin(), held.end());
  for (Eigen::Index v = 0; v < style.cols(); ++v)
    if ((style.col(v) - source.col(v)).norm() < 1e-9) all.insert(static_cast<int>(v));
  const std::vector<int> vertices(all.begin(), all.end());
  Eigen::Matrix3Xd to(3, static_cast<Eigen::Index>(vertices.size()));
  for (Eigen::Index i = 0; i < to.cols(); ++i) to.col(i) = style.col(vertices[static_cast<std::size_t>(i)]);
  const Eigen::Matrix3Xd rigid = as_rigid_as_possible(source, triangles, vertices, to);
  return {change(source, triangles, style), change(source, triangles, rigid)};
}

}  // namespace toile::testing
