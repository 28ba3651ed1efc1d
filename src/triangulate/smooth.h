#pragma once
// Smoothing of a filled polygon.

#include "triangulate/fill.h"

namespace toile {

// Smallest angle of a triangle, degrees.
double smallest_angle(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c);

// `near[i]`: a point before the i-th and not far from it. Moves the points after the first `corners` to the middle of their
// neighbours and triangulates again (Delaunay), `rounds` times; a point stays where the move would leave an angle below
// `wanted_angle` (degrees) that is also smaller than before.
Filling smooth(std::vector<Eigen::Vector2d> points, const std::vector<int>& near, int corners, int rounds, double wanted_angle);

}  // namespace toile
