#pragma once
// Motion to rest in small explicit steps (symplectic Euler): forces, velocity, strain limit (Bridson et al. 2003), friction of
// the body last, so that what sticks does so exactly; then move, out of the body if need be (Mueller et al. 2007). Kinetic
// energy is taken away at each of its peaks (Barnes 1999).

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "drape/mass_spring/cloth.h"

namespace toile::mass_spring {

struct RelaxationOptions {
  double tolerance = 1e-3;                // on the static residual
  double window = 0.25;                   // s, over which
  double still = 0.1e-3;                  // m, no vertex may have moved further
  double longest = 40;                    // s of motion
  std::optional<double> time_limit = {};  // s of computing
  std::function<bool()> stop = {};
  std::function<void(int step, double residual)> progress = {};
};

struct Rest {
  Eigen::Matrix3Xd x;
  double residual = 0;
  int steps = 0;
  bool settled = false;
};

// From `start` to rest; the best state found when it is not reached.
Rest relax(const Cloth& cloth, const Eigen::Matrix3Xd& start, const RelaxationOptions& options = {});

}  // namespace toile::mass_spring
