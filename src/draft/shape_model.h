#pragma once
// Shared shapes as functions of the unknowns of the fit: corners, bends of curves, turn points along straight lines.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "draft/alike.h"

namespace toile {

// offset + factor * unknown; without an unknown (-1) a constant. Symmetry is two coordinates on one unknown.
struct Coordinate {
  int unknown = -1;
  double factor = 0, offset = 0;
  double value(const Eigen::VectorXd& unknowns) const { return unknown < 0 ? offset : offset + factor * unknowns(unknown); }
};

// A point with its derivatives.
struct ModelPoint {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  std::vector<std::pair<int, Eigen::Vector2d>> slopes;  // (unknown, d at / d unknown); an unknown may appear twice
};

// A length with its derivatives.
struct ModelLength {
  double value = 0;
  std::vector<std::pair<int, double>> slopes;
};

struct ShapeModel {
  SharedShape shape;
  std::vector<std::array<Coordinate, 2>> corners;
  // By run: what bends a curve beyond the similarity of its chord, control points of a uniform cubic B-spline that is zero at
  // both ends; none where the similarity is enough.
  std::vector<std::vector<std::array<Coordinate, 2>>> bends;
};

// Values of the `count` basis functions that vanish at 0 and 1, at `t`: cubic, uniform knots, count >= 2.
std::vector<double> bend_basis(int count, double t);

// Adds the unknowns of a shape (corners, then `bend_counts` control points by run) to `unknowns`, which gets their first
// values.
ShapeModel model_of(SharedShape shape, const std::vector<int>& bend_counts, std::vector<double>& unknowns);

// The point at fraction `t` of run `run`; on a straight run `t` may depend on unknowns.
ModelPoint point_on(const ShapeModel& model, int run, const Coordinate& t, const Eigen::VectorXd& unknowns);

// Length of the polyline through `points`, and of a straight run between two fractions.
ModelLength length_of(const std::vector<ModelPoint>& points);

}  // namespace toile
