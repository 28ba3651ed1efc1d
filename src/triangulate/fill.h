#pragma once
// A polygon filled with well-shaped triangles whose only vertices on the outline are the polygon's own.

#include <Eigen/Core>
#include <array>
#include <vector>

namespace toile {

struct Filling {
  std::vector<Eigen::Vector2d> points;        // the polygon's corners first, then points inside
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise
};

// `loop`: simple, counter-clockwise. Triangles are about `edge_length` (m) in size, and about as large as the polygon's sides
// where these are shorter. Angles below `smallest_angle` (degrees) remain only where the polygon itself forces them: at sharp
// corners and in parts narrower than its sides are long. Points inside come from an advancing front (Rebay 1993), then are
// smoothed.
Filling fill(const std::vector<Eigen::Vector2d>& loop, double edge_length, double smallest_angle);

}  // namespace toile
