#pragma once
// Cloth against body: a C2 normal pressure that acts within `reach` of the body's surface, and Coulomb friction anchored where
// the cloth started. Energies are per garment vertex; `area` is its rest area.

#include <Eigen/Core>

#include "body/body.h"
#include "garment/fabric.h"

namespace toile::fem {

struct ContactLaw {
  double pressure = 1500;  // Pa; quadratic from zero at `reach`
  double firmness = 60;    // times that once the cloth is pressed closer than half of `reach`: stiff cloth over a sharp edge
  double hardness = 2000;  // times that once it is pressed a quarter of `reach` into the body: cloth much too tight
  double reach = 1e-3;     // m
  double slip = 0.2e-3;    // m, over which friction builds up; far below it the cloth sticks
  double friction = 0.4;   // Coulomb coefficient
};

// The law between this cloth and this body. On a figure (with bones) below 1.6 m the cloth comes proportionally closer, as the
// distance field gets finer, but not closer than half its own thickness.
ContactLaw contact_law(const Fabric& fabric, const Body& body);

// `full` (m, on a figure of 1.6 m or more) on this one, but no less than `least` unless it was.
double replica_reach(double full, double least, const Body& body);

// Normal contact at distance d: energy area * p0 * reach / 3 * (u^3 + firmness * w^3 + hardness * v^3) with u = 1 - d / reach,
// w = u - 1/2, v = u - 5/4, each where positive.
double normal_energy(const ContactLaw&, double area, double distance);
double normal_force(const ContactLaw&, double area, double distance);      // N, >= 0
double normal_stiffness(const ContactLaw&, double area, double distance);  // N/m, >= 0

// Friction of one vertex while its normal force and normal are held fixed (lagged): potential
// friction * force * (sqrt(|u|^2 + slip^2) - slip), u = tangential part of x - anchor.
struct FrictionState {
  Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitY();
  double force = 0;  // N, lagged
};
double friction_energy(const ContactLaw&, const FrictionState&, const Eigen::Vector3d& x);
Eigen::Vector3d friction_gradient(const ContactLaw&, const FrictionState&, const Eigen::Vector3d& x);
Eigen::Matrix3d friction_hessian(const ContactLaw&, const FrictionState&, const Eigen::Vector3d& x);  // PSD

}  // namespace toile::fem
