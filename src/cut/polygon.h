#pragma once
// Closed polygons as plain lists of points, no repeated last point. Metres.

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

namespace toile {

using Polygon = std::vector<Eigen::Vector2d>;

inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// A quarter turn clockwise: of a direction of travel round a counter-clockwise outline, the outward normal.
inline Eigen::Vector2d turned_right(const Eigen::Vector2d& d) { return {d.y(), -d.x()}; }

double signed_area(const Polygon& polygon);
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

// Where on segment ab (0..1) and on segment cd (0..1) they cross or touch; parallel segments never do.
std::optional<std::pair<double, double>> crossing(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
                                                  const Eigen::Vector2d& d);

double distance(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b);
// Between segments ab and cd; 0 when they cross.
double distance(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c, const Eigen::Vector2d& d);

// The first two segments (by the index of their first point) that cross, touch without being neighbours, or, being neighbours,
// fold back onto each other; empty when the polygon is simple.
std::optional<std::pair<int, int>> first_self_crossing(const Polygon& polygon);

// Whether any part of one lies inside or on the other. Exact for simple polygons.
bool overlap(const Polygon& a, const Polygon& b);

}  // namespace toile
