#pragma once
// Constrained Delaunay triangulation of a simple polygon with points inside it.

#include <Eigen/Core>
#include <array>
#include <vector>

namespace toile {

// Triangles (counter-clockwise, sorted, smallest vertex first) of the region inside the polygon `points[0 .. corners - 1]`; the
// other points lie inside it. Its sides are kept as they are. Throws std::invalid_argument when they cross.
std::vector<std::array<int, 3>> constrained_delaunay(const std::vector<Eigen::Vector2d>& points, int corners);

}  // namespace toile
