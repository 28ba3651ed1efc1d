#include "style/soft_terms.h"

#include <algorithm>

namespace toile {

StyleWeights style_weights(double body_height) {
  StyleWeights weights;
  weights.length = 0.05 * body_height;
  return weights;
}

SoftTerm proportion_term(int vertex, const Eigen::Vector3d& axis, double coordinate, double area, const StyleWeights& weights) {
  return {vertex, axis, coordinate, weights.proportion * area / (weights.length * weights.length)};
}

SoftTerm fit_term(int vertex, const SkinPlace& skin, double gap, double release, double area, const StyleWeights& weights) {
  return {vertex, skin.outward, skin.outward.dot(skin.at) + gap,
          weights.fit * release * area / (weights.length * weights.length)};
}

SoftTerm contact_term(int vertex, const SkinPlace& skin, double least_gap, double area, const StyleWeights& weights) {
  return {vertex, skin.outward, skin.outward.dot(skin.at) + least_gap,
          weights.contact * area / (weights.length * weights.length)};
}

double soft_energy(const std::vector<SoftTerm>& terms, const Eigen::Matrix3Xd& x) {
  double energy = 0;
  for (const SoftTerm& term : terms) {
    const double off = term.direction.dot(x.col(term.vertex)) - term.goal;
    energy += term.weight * off * off;
  }
  return energy;
}

double smoothstep(double at, double from, double to) {
  if (to <= from) return at >= to ? 1 : 0;
  const double u = std::clamp((at - from) / (to - from), 0.0, 1.0);
  return u * u * (3 - 2 * u);
}

}  // namespace toile
