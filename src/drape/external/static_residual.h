#pragma once
// How far any shape of a garment is from rest, whoever found it.

#include <Eigen/Core>

#include "drape/simulator.h"

namespace toile::external {

// Norm of the unbalanced forces over the norm of the weight (Drape::residual), by the energy of fem but without its contact
// laws, which other programs do not share: a vertex within `touch` of the body may be pushed outwards by any amount, and held
// by friction of at most the coefficient times that. Cloth that rests on cloth counts as not held: there the figure is an upper
// bound.
double static_residual(const DrapeRequest& request, const Eigen::Matrix3Xd& x, double touch = 3e-3);

}  // namespace toile::external
