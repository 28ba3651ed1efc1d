#pragma once
// Does cloth pass through itself? Decided exactly.

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace toile {

// Pairs of triangles (smaller index first, sorted) that intersect, by exact predicates. Triangles that share one vertex count
// when they meet anywhere else; two triangles that share an edge never count, nor does a triangle without area.
std::vector<std::pair<int, int>> intersecting_triangles(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

}  // namespace toile
