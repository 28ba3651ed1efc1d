#include "drape/fem/self_contact.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace toile::fem {
namespace {

// Weight of corner i in the vector from the second side's closest point to the first's.
double signed_weight(const NearPair& pair, int i) { return i < pair.first ? pair.weight(i) : -pair.weight(i); }

double distance_at(const NearPair& pair, const Eigen::Matrix3Xd& x) {
  double distance = 0;
  for (int i = 0; i < 4; ++i)
    distance += signed_weight(pair, i) * pair.normal.dot(x.col(pair.vertex[static_cast<std::size_t>(i)]));
  return distance;
}

}  // namespace

double barrier(const SelfContactLaw& law, double distance) {
  const double u = distance / law.reach;
  if (u >= 1) return 0;
  if (u <= 0) return std::numeric_limits<double>::infinity();
  return -law.pressure * law.reach * (1 - u) * (1 - u) * std::log(u);
}

double barrier_slope(const SelfContactLaw& law, double distance) {
  const double u = distance / law.reach;
  if (u >= 1) return 0;
  return law.pressure * (1 - u) * (2 * std::log(u) - (1 - u) / u);
}

double barrier_curvature(const SelfContactLaw& law, double distance) {
  const double u = distance / law.reach;
  if (u >= 1) return 0;
  const double gap = 1 - u;
  return law.pressure / law.reach * (-2 * std::log(u) + 4 * gap / u + gap * gap / (u * u));
}

double self_contact_energy(const SelfContact& contact, const Eigen::Matrix3Xd& x) {
  double sum = 0;
  for (std::size_t p = 0; p < contact.pairs.size(); ++p)
    sum += contact.area[p] * barrier(contact.law, distance_at(contact.pairs[p], x));
  return sum;
}

void add_self_contact(const SelfContact& contact, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& gradient) {
  for (std::size_t p = 0; p < contact.pairs.size(); ++p) {
    const NearPair& pair = contact.pairs[p];
    const double slope = contact.area[p] * barrier_slope(contact.law, distance_at(pair, x));
    if (slope == 0) continue;
    for (int i = 0; i < 4; ++i)
      gradient.col(pair.vertex[static_cast<std::size_t>(i)]) += slope * signed_weight(pair, i) * pair.normal;
  }
}

void add_self_contact(const SelfContact& contact, const Eigen::Matrix3Xd& x, BlockMatrix& hessian) {
  for (std::size_t p = 0; p < contact.pairs.size(); ++p) {
    const NearPair& pair = contact.pairs[p];
    const double curvature = contact.area[p] * barrier_curvature(contact.law, distance_at(pair, x));
    if (curvature == 0) continue;
    const Eigen::Matrix3d normals = curvature * pair.normal * pair.normal.transpose();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j <= i; ++j)
        hessian.add(pair.vertex[static_cast<std::size_t>(i)], pair.vertex[static_cast<std::size_t>(j)],
                    signed_weight(pair, i) * signed_weight(pair, j) * normals);
  }
}

std::vector<std::pair<int, int>> coupled_vertices(const SelfContact& contact) {
  std::vector<std::pair<int, int>> coupled;
  for (const NearPair& pair : contact.pairs)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) coupled.emplace_back(pair.vertex[i], pair.vertex[j]);
  return coupled;
}

}  // namespace toile::fem
