#pragma once
// Plain as-rigid-as-possible deformation (Sorkine and Alexa 2007, by CGAL): what the style energy is held against (paper Fig.
// 3).

#include <Eigen/Core>
#include <vector>

namespace toile::testing {

// `x` with the vertices `held` taken to the columns of `to` (3 x held) and all others as rigid as possible.
Eigen::Matrix3Xd as_rigid_as_possible(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xi& triangles,
                                      const std::vector<int>& held, const Eigen::Matrix3Xd& to);

}  // namespace toile::testing
