#include "drape/flat_layers.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace toile {
namespace {

constexpr double gap = 0.02;        // m, between flat panels of two layers
constexpr double past = 0.10;       // m, that an outer panel reaches past those under it on either side: they sway
constexpr double row = 0.03;        // m
constexpr double at_middle = 0.08;  // m, from x = 0
constexpr double across = 0.03;     // m
constexpr double most_wider = 1.8;

// Farthest from x = 0 by height.
std::map<int, double> reach(const std::vector<const Eigen::Matrix3Xd*>& panels) {
  std::map<int, double> farthest;
  for (const Eigen::Matrix3Xd* x : panels)
    for (const auto& at : x->colwise()) {
      double& far = farthest[static_cast<int>(std::floor(at.y() / row))];
      far = std::max(far, std::abs(at.x()));
    }
  return farthest;
}

}  // namespace

std::vector<std::size_t> from_inside(const std::vector<int>& layer) {
  std::vector<std::size_t> order(layer.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return layer[a] < layer[b]; });
  return order;
}

void move_outside(const Eigen::Matrix3Xd& inner, const Eigen::Vector3d& outside, Eigen::Matrix3Xd& x) {
  for (const Eigen::Vector3d& across : {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(outside.cross(Eigen::Vector3d::UnitY()))}) {
    const Eigen::RowVectorXd own = across.transpose() * x, other = across.transpose() * inner;
    if (own.minCoeff() > other.maxCoeff() || own.maxCoeff() < other.minCoeff()) return;
  }
  const double lack = (outside.transpose() * inner).maxCoeff() + gap - (outside.transpose() * x).minCoeff();
  if (lack > 0) x.colwise() += lack * outside;
}

double widening(const std::vector<const Eigen::Matrix3Xd*>& inner, const std::vector<const Eigen::Matrix3Xd*>& outer) {
  const auto under = reach(inner);
  double factor = 1;
  for (const auto& [height, own] : reach(outer))
    if (const auto at = under.find(height); at != under.end() && own > 0) factor = std::max(factor, (at->second + past) / own);
  return std::min(factor, most_wider);
}

void widen(double factor, Eigen::Matrix3Xd& x) {
  if (factor <= 1) return;
  const double low = x.row(0).minCoeff(), high = x.row(0).maxCoeff();
  const double side = low + high > 0 ? 1 : -1;  // of the middle
  const double near = side > 0 ? low : -high, far = side > 0 ? high : -low;
  const bool ends_there = std::abs(near) < at_middle && far > 2 * at_middle;
  for (double& at : x.row(0)) {
    const double share = (side * at - near) / (far - near);
    at = ends_there ? side * std::lerp(near - across, factor * far, share) : factor * at;
  }
}

}  // namespace toile
