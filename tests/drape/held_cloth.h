#pragma once
// Equilibrium of the fem model with some vertices held where they are, for tests of the model without a body.

#include <Eigen/Core>
#include <vector>

#include "drape/fem/model.h"

namespace toile::test {

struct HeldCloth {
  Eigen::Matrix3Xd x;
  Eigen::Matrix3Xd reaction;  // N, of the model's forces: what the held vertices must be pushed with to stay
  double residual = 0;        // of the free vertices against the weight
  int steps = 0;
};

// Newton's method with pseudo-time regularisation on the model's own energy; no friction.
HeldCloth settle_held(const fem::Model& model, const Eigen::Matrix3Xd& start, const std::vector<int>& held,
                      double tolerance = 1e-7);

}  // namespace toile::test
