#pragma once
// A cloth moved as far as it can go without passing through itself.

#include <Eigen/Core>

namespace toile {

// `from`, free of intersections, moved towards `to` (m, 3 x vertices) as far as what is in the way lets it slide; free of
// intersections likewise. Vertices that are where they go stay there. Deterministic.
Eigen::Matrix3Xd without_crossing(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, const Eigen::Matrix3Xi& triangles);

}  // namespace toile
