#pragma once
// The soft parts of the style energy: proportion (along the bone), fit (away from the skin) and contact, each a square of one
// coordinate of one vertex, weighted by the area the vertex stands for.

#include <Eigen/Core>
#include <vector>

namespace toile {

// weight * (direction . x_vertex - goal)^2
struct SoftTerm {
  int vertex = 0;
  Eigen::Vector3d direction = Eigen::Vector3d::UnitY();  // unit
  double goal = 0;                                       // m
  double weight = 0;
};

// A place on the skin and the unit direction away from the body there: the p_m and m of the paper's relative parameterisation.
struct SkinPlace {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();
};

// Weights against E_shape = 1, per area over (length)^2; length is 5 % of the body's height. Measured; the originals are
// unknown.
struct StyleWeights {
  double fit = 10;
  double proportion = 100;
  double contact = 100;
  double length = 0.085;  // m
};
StyleWeights style_weights(double body_height);

// E_rl: keeps axis . x at axis . source.
SoftTerm proportion_term(int vertex, const Eigen::Vector3d& axis, double coordinate, double area, const StyleWeights&);

// E_fit: keeps the vertex `gap` metres off the skin; release in [0, 1] is how much of that is asked for.
SoftTerm fit_term(int vertex, const SkinPlace& skin, double gap, double release, double area, const StyleWeights&);

// Pushes the vertex out to `least_gap`.
SoftTerm contact_term(int vertex, const SkinPlace& skin, double least_gap, double area, const StyleWeights&);

double soft_energy(const std::vector<SoftTerm>& terms, const Eigen::Matrix3Xd& x);

// 0 at `from` or before, 1 at `to` or beyond, C1 between.
double smoothstep(double at, double from, double to);

}  // namespace toile
