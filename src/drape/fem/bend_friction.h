#pragma once
// Friction between the yarns of bent cloth, what a Kawabata tester prints as 2HB: a moment that resists any change of curvature
// from the start, as Coulomb friction on the body resists sliding. Folds stay where they fell. The law of a bent cloth is
// Grosberg's (Textile Research J. 36, 1966), moment = friction +- stiffness x curvature; Miguel et al., "Modeling and
// Estimation of Internal Friction in Cloth" (ACM TOG 32(6), 2013) show the preferred wrinkles it makes.

#include <Eigen/Core>
#include <vector>

#include "drape/fem/bending.h"
#include "drape/fem/membrane.h"
#include "garment/fabric.h"
#include "garment/mesh.h"

namespace toile::fem {

using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

// Energy moment * (sqrt(d^2 + slack^2) - slack) of the change d of the angle between the two triangles: a spring while |d| is
// below `slack`, the full moment beyond it.
struct BendFriction {
  double moment = 0;  // N m; so that on average over the directions of the mesh a cylinder takes moment per width x curvature x
                      // area
  double slack = 0;   // rad
};

// One for each hinge of bending_hinges; moment 0 where the fabric has no friction. Layers count as so many separate cloths.
std::vector<BendFriction> bend_frictions(const GarmentMesh& garment, const Fabric& fabric, const std::vector<Hinge>& hinges);

// Angle by which the second triangle is turned from the plane of the first, (-pi, pi].
double hinge_angle(const Hinge& hinge, const Eigen::Matrix3Xd& x);

// `anchor`: the angle that the cloth has come to rest at.
double bend_friction_energy(const BendFriction& friction, double anchor, const Hinge& hinge, const Eigen::Matrix3Xd& x);

// Adds the gradient by x, and the Hessian when it is asked for; Curvature::clamped leaves out what may be negative. The order
// is that of hinge.vertex. Nothing at triangles without area.
void bend_friction_derivatives(const BendFriction& friction, double anchor, const Hinge& hinge, const Eigen::Matrix3Xd& x,
                               Curvature curvature, Vector12& gradient, Matrix12* hessian);

}  // namespace toile::fem
