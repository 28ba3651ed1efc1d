#pragma once
// What a fabric does when it is pulled, bent and laid on a body. SI throughout.

#include <string>

namespace toile {

struct Fabric {
  std::string name;
  double area_density = 0.2;   // kg/m^2
  double stretch_warp = 1000;  // N/m, membrane stiffness along the grain
  double stretch_weft = 600;   // N/m, across it
  double stretch_cross = 150;  // N/m, coupling (Poisson) term C12
  double shear = 60;           // N/m, C66
  double bend_warp = 1e-5;     // N m, bending stiffness of a strip cut along the grain
  double bend_weft = 7e-6;     // N m
  double bend_friction = 0;    // N (moment per width) by which a bend stays where it is, half of KES 2HB
  double friction = 0.4;       // Coulomb coefficient, fabric on body
  double thickness = 0.5e-3;   // m
  double most_stretch = 0.15;  // strain beyond which the fabric stiffens sharply
  std::string source;          // where the figures were read
  bool operator==(const Fabric&) const = default;
};

}  // namespace toile
