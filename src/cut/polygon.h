#pragma once
// Closed polygons as plain lists of points, no repeated last point. Metres.

#include <Eigen/Core>
#include <vector>

#include "geometry/plane_segments.h"
#include "geometry/self_crossing.h"

namespace toile {

using Polygon = std::vector<Eigen::Vector2d>;

constexpr double touching = 1e-9;  // m, lines this near are one to every cutter

// A quarter turn clockwise: of a direction of travel round a counter-clockwise outline, the outward normal.
inline Eigen::Vector2d turned_right(const Eigen::Vector2d& d) { return {d.y(), -d.x()}; }

double signed_area(const Polygon& polygon);
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

// Whether any part of one lies inside or on the other. Exact for simple polygons.
bool overlap(const Polygon& a, const Polygon& b);

}  // namespace toile
