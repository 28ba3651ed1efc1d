#include "drape/fem/contact.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace toile::fem {
namespace {

struct Depth {
  double reached, pressed, sunk;  // u, w and v
};

Depth depth(const ContactLaw& law, double distance) {
  const double u = (law.reach - distance) / law.reach;
  return {std::max(u, 0.0), std::max(u - .5, 0.0), std::max(u - 1.25, 0.0)};
}

Eigen::Vector3d slide(const FrictionState& state, const Eigen::Vector3d& x) {
  const Eigen::Vector3d moved = x - state.anchor;
  return moved - state.normal.dot(moved) * state.normal;
}

}  // namespace

double replica_reach(double full, double least, const Body& body) {
  if (body.form.bones.empty()) return full;  // a thing, not a small figure
  return std::min(full, std::max(full * body.form.height / 1.6, least));
}

ContactLaw contact_law(const Fabric& fabric, const Body& body) {
  ContactLaw law;
  law.reach = replica_reach(law.reach, fabric.thickness / 2, body);
  law.slip *= law.reach / ContactLaw{}.reach;
  law.friction = fabric.friction;
  return law;
}

double normal_energy(const ContactLaw& law, double area, double distance) {
  const auto [u, w, v] = depth(law, distance);
  return area * law.pressure * law.reach / 3 * (u * u * u + law.firmness * w * w * w + law.hardness * v * v * v);
}

double normal_force(const ContactLaw& law, double area, double distance) {
  const auto [u, w, v] = depth(law, distance);
  return area * law.pressure * (u * u + law.firmness * w * w + law.hardness * v * v);
}

double normal_stiffness(const ContactLaw& law, double area, double distance) {
  const auto [u, w, v] = depth(law, distance);
  return 2 * area * law.pressure / law.reach * (u + law.firmness * w + law.hardness * v);
}

double friction_energy(const ContactLaw& law, const FrictionState& state, const Eigen::Vector3d& x) {
  if (state.force <= 0) return 0;
  return law.friction * state.force * (std::sqrt(slide(state, x).squaredNorm() + law.slip * law.slip) - law.slip);
}

Eigen::Vector3d friction_gradient(const ContactLaw& law, const FrictionState& state, const Eigen::Vector3d& x) {
  if (state.force <= 0) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d u = slide(state, x);
  return law.friction * state.force / std::sqrt(u.squaredNorm() + law.slip * law.slip) * u;
}

Eigen::Matrix3d friction_hessian(const ContactLaw& law, const FrictionState& state, const Eigen::Vector3d& x) {
  if (state.force <= 0) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d u = slide(state, x);
  const double r = std::sqrt(u.squaredNorm() + law.slip * law.slip);
  const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - state.normal * state.normal.transpose();
  return law.friction * state.force / r * (tangent - u * u.transpose() / (r * r));
}

}  // namespace toile::fem
