#pragma once
// The curves GarmentCode draws between two vertices of a panel, as points.

#include <Eigen/Core>
#include <vector>

namespace toile {

// The points strictly between the ends of a Bezier curve with these control points (ends included, 3 or 4 of them), equally
// spaced in its parameter, so that no chord departs from the curve by more than `tolerance`.
std::vector<Eigen::Vector2d> bezier_between(const std::vector<Eigen::Vector2d>& control, double tolerance);

// The points strictly between `from` and `to` of the circular arc of `radius` that bulges to the right of the way from one to
// the other (the long way round when `large`), or to the left. A radius below half the distance is taken as half of it.
std::vector<Eigen::Vector2d> arc_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double radius, bool large,
                                         bool right, double tolerance);

}  // namespace toile
