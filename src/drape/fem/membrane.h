#pragma once
// Orthotropic membrane energy of one triangle, St. Venant-Kirchhoff in the panel's own rest frame, stiffening beyond the
// fabric's stretch limit. Axis 0 of the frame is the warp, axis 1 the weft.

#include <Eigen/Core>
#include <array>

#include "garment/fabric.h"

namespace toile::fem {

using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;

struct MembraneElement {
  std::array<int, 3> vertex{};           // garment vertices
  double area = 0;                       // m^2, rest
  double layers = 1;                     // of cloth: the stiffness is so many times that of one
  Eigen::Matrix<double, 2, 3> gradient;  // of the three hat functions, 1/m, in (warp, weft)
};

// `rest_edges`: columns b - a, c - a in the panel's rest plane; `warp`: unit grain direction there.
MembraneElement membrane_element(const std::array<int, 3>& vertex, const Eigen::Matrix2d& rest_edges,
                                 const Eigen::Vector2d& warp);

// Coefficients of the energy per rest area: 1/2 E^T C E + stiffening beyond `limit`.
struct MembraneLaw {
  double c11, c22, c12, c66;  // N/m
  double limit;               // Green strain where stiffening begins
};
MembraneLaw membrane_law(const Fabric& fabric);

// Its corners out of all positions, one column each.
Eigen::Matrix3d corners_of(const MembraneElement&, const Eigen::Matrix3Xd& x);

// Energy (J) of the triangle at corner positions `x` (one column per corner).
double membrane_energy(const MembraneElement&, const MembraneLaw&, const Eigen::Matrix3d& x);

enum class Curvature {
  full,
  clamped
};  // clamped: compressive stress left out of the geometric term, so that the matrix is PSD

// Adds to `gradient` (N) and, when asked, `hessian` (N/m); entries by corner, xyz.
double membrane_derivatives(const MembraneElement&, const MembraneLaw&, const Eigen::Matrix3d& x, Curvature, Vector9& gradient,
                            Matrix9* hessian);

}  // namespace toile::fem
