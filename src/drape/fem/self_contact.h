#pragma once
// Cloth against itself: a barrier between near parts, with the pairs, the weights of their closest points and their normals
// held fixed while the energy is minimised, so that its derivatives are those of a function of one distance.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "collide/near_pairs.h"
#include "sparse/block_matrix.h"

namespace toile::fem {

struct SelfContactLaw {
  double pressure = 1500;  // Pa
  double reach = 1.5e-3;   // m, between the layers' middle surfaces
};

struct SelfContact {
  SelfContactLaw law;
  std::vector<NearPair> pairs;
  std::vector<double> area;  // m^2, what each pair stands for
};

// The barrier of one pair per area, over distance d < reach: p0 * reach * (1 - u)^2 * (-ln u), u = d / reach; infinite for
// d <= 0. Li et al. 2020 (IPC), Eq. 6, scaled.
double barrier(const SelfContactLaw&, double distance);
double barrier_slope(const SelfContactLaw&, double distance);
double barrier_curvature(const SelfContactLaw&, double distance);

double self_contact_energy(const SelfContact&, const Eigen::Matrix3Xd& x);  // J
void add_self_contact(const SelfContact&, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& gradient);
void add_self_contact(const SelfContact&, const Eigen::Matrix3Xd& x, BlockMatrix& hessian);  // PSD

// The vertex pairs that share a block of the Hessian because of these contacts.
std::vector<std::pair<int, int>> coupled_vertices(const SelfContact&);

}  // namespace toile::fem
