#pragma once

#include <Eigen/Core>

namespace toile {

// Unit normals by vertex of `x` (3 x vertices), weighted by the areas of the triangles round each; zero where there are none.
Eigen::Matrix3Xd vertex_normals(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xi& triangles);

}  // namespace toile
