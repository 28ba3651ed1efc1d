#pragma once
// A run of an outline as one of the curves GarmentCode knows.

#include <Eigen/Core>
#include <vector>

namespace toile {

struct FittedCurve {
  enum class Kind { line, quadratic, cubic, circle } kind = Kind::line;
  std::vector<Eigen::Vector2d> control;  // one or two inner control points of a Bezier curve
  double radius = 0;                     // m
  bool large = false, right = false;     // of a circle: the long way round; bulging to the right
  double departure = 0;                  // m, of the farthest of the points
  std::size_t farthest = 0;              // which that is
};

// The curve that comes nearest to `points` (two at least, ends included, which it keeps): exact where the points were sampled
// from a line, a Bezier curve in equal steps of its parameter, or a circle.
FittedCurve fit_curve(const std::vector<Eigen::Vector2d>& points);

}  // namespace toile
