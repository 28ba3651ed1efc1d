#pragma once
// Static equilibrium by Newton's method with pseudo-time regularisation (mass / dt^2), friction forces lagged between steps.

#include <functional>
#include <optional>

#include "drape/fem/model.h"

namespace toile::fem {

struct NewtonOptions {
  double tolerance = 1e-3;  // on |gradient| / |weight|, friction at the true normal forces
  int most_steps = 300;
  Curvature curvature = Curvature::full;  // clamped: projected Newton, the reference
  double first_dt = 0.05;                 // s
  double growth = 1.6;                    // of dt, per step
  double most_dt = 5;                     // s
  double step_cap = 0.05;                 // m, largest move of a vertex in one step
  double least_force_share = 0.3;         // under-relaxation of the lagged normal forces, while far; 1 does not converge
  double most_force_share = 0.7;          // near equilibrium, where it sets the rate of convergence
  std::optional<double> time_limit = {};  // s
  std::function<bool()> stop = {};
  std::function<void(int step, double residual)> progress = {};
};

struct Equilibrium {
  Eigen::Matrix3Xd x;
  double residual = 0;
  int steps = 0;
  bool settled = false;
};

// From `start`, where friction is anchored, to equilibrium; the best state found when it is not reached.
Equilibrium find_equilibrium(const Model& model, const Eigen::Matrix3Xd& start, const NewtonOptions& options = {});

}  // namespace toile::fem
