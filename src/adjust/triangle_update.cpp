#include "adjust/triangle_update.h"

#include <Eigen/Dense>
#include <cmath>

#include "geometry/triangle_shape.h"

namespace toile {
namespace {

// Beyond this a single step is not believed: a triangle folded onto itself, not cloth that stretched.
constexpr double most_change = 2;

bool is_collapsed(const Eigen::Matrix2d& shape) {
  return !shape.allFinite() || !(std::abs(shape.determinant()) > 1e-6 * shape.squaredNorm());
}

// `shape` turned by the rotation that makes shape * onto^-1 symmetric and positive.
Eigen::Matrix2d turned_onto(const Eigen::Matrix2d& onto, const Eigen::Matrix2d& shape) {
  const Eigen::Matrix2d map = shape * onto.inverse();
  const double angle = std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1));
  return Eigen::Rotation2Dd(-angle).toRotationMatrix() * shape;
}

template <class Function>
Eigen::Matrix2d on_principal_stretches(const Eigen::Matrix2d& symmetric, const Function& function) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes((symmetric + symmetric.transpose()) / 2);
  const Eigen::Vector2d values = axes.eigenvalues().unaryExpr(function);
  return axes.eigenvectors() * values.asDiagonal() * axes.eigenvectors().transpose();
}

}  // namespace

Eigen::Matrix2d updated_rest(const Eigen::Matrix2d& rest, const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal,
                             double gain) {
  if (is_collapsed(draped) || is_collapsed(goal)) return rest;
  const Eigen::Matrix2d stretch = on_principal_stretches(turned_onto(draped, goal) * draped.inverse(), [&](double value) {
    return std::pow(std::clamp(value, 1 / most_change, most_change), gain);
  });
  return next_rest(rest, draped, stretch * draped);
}

Eigen::Matrix2d without_compression(const Eigen::Matrix2d& goal, const Eigen::Matrix2d& rest, const Eigen::Matrix2d& source) {
  if (is_collapsed(source) || is_collapsed(goal)) return goal;
  const Eigen::Matrix2d map = source * rest.inverse();
  const Eigen::Matrix2d undone = on_principal_stretches(
      map * map.transpose(), [](double square) { return std::clamp(1 / std::sqrt(square), 1.0, most_change); });
  return undone * turned_onto(source, goal);
}

}  // namespace toile
