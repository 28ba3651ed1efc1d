#pragma once
// A shape that keeps the style held against one that keeps the surface rigid (paper Fig. 3).

#include <Eigen/Core>
#include <vector>

namespace toile::testing {

// How a shape differs from its source.
struct ShapeChange {
  double turned = 0;  // radians, mean of the normals of what moved
  double curved = 0;  // radians, sum of the absolute changes of angle defects at inner vertices
  double added = 0;   // radians, by how much more the angle defects that grew are
  double total = 0;   // radians, sum of absolute angle defects less the source's: the Gaussian curvature of the whole
};

struct AgainstRigid {
  ShapeChange style, rigid;
};

// `style` (3 x vertices) against the shape with the same `held` vertices, and everything that `style` left where it was, while
// the rest is as rigid as possible to `source`.
AgainstRigid against_rigid(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& style,
                           const std::vector<int>& held);

}  // namespace toile::testing
