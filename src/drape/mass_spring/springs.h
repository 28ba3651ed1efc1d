#pragma once
// Edge springs (Bridson et al. 2003) whose network has the stiffness of the fabric: k = w (A1 + A2) / L^2 as for an even sheet,
// with w by direction in the panel's own rest frame, so that around every vertex the network pulls as warp and weft do, as
// nearly as springs in the few directions of its edges can.

#include <Eigen/Core>
#include <vector>

#include "garment/fabric.h"
#include "garment/mesh.h"

namespace toile::mass_spring {

// Energy k L^2 phi(E), E = ((l / L)^2 - 1) / 2; for small strain k / 2 (l - L)^2. An edge on a seam has one for each panel.
struct Spring {
  int a = 0, b = 0;      // garment vertices
  double rest = 0;       // L, m
  double stiffness = 0;  // k, N/m
};

// What springs of any stiffness have in common: linear, steeper beyond the fabric's limit, slack where it is squeezed so far
// that cloth wrinkles finer than the mesh.
struct SpringLaw {
  double limit = 0.15;  // strain E at which the fabric stiffens
};

struct Pull {
  double energy = 0;  // phi(E)
  double pull = 0;    // its derivative
  double slope = 0;   // and second derivative
};
Pull pull_at(const SpringLaw& law, double strain);

double spring_energy(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x);  // J
// N, on `a`; on `b` its opposite.
Eigen::Vector3d spring_force(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x);
// N/m, the block of `a` with itself, and the opposite of that of `a` with `b`. `pull`: phi'(E) that it is to be taken for; not
// negative makes it positive semidefinite.
Eigen::Matrix3d spring_stiffness(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x, double pull);
double pull_of(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x);  // phi'(E)

// Plane stiffness that springs can have: c12 = c66 (Cauchy's relation), N/m.
struct NetworkStiffness {
  double warp = 0, weft = 0, cross = 0;
};
// That of the fabric with Young's moduli along warp and weft kept; `cross` is (c12 + 2 c66) / 3, or more where no springs that
// push and pull could be so soft on the bias.
NetworkStiffness network_stiffness(const Fabric& fabric);

std::vector<Spring> edge_springs(const GarmentMesh& garment, const Fabric& fabric);

}  // namespace toile::mass_spring
