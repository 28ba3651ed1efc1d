#pragma once
// Static equilibrium by Newton's method with pseudo-time regularisation (mass / dt^2), friction forces lagged between steps.

#include <functional>
#include <limits>
#include <optional>

#include "drape/fem/model.h"

namespace toile::fem {

// What friction may take up of the force on a vertex at rest: what it gives at that distance from its anchor, or as much as is
// needed and its normal force allows (Coulomb's cone).
enum class Holding { anchored, cone };

// How the search goes where springs have to be followed, which are stiff and have no resistance to being turned.
struct SpringSteps {
  // Residual above which the Hessian is clamped outright. Nearer to rest it is the full one; where that is not positive
  // definite, its bending part counts several times, which holds single vertices and lets folds go.
  double clamped_above = std::numeric_limits<double>::infinity();
  // m from the body: what a step presses deeper, and deeper than it was, is moved back out (Mueller et al. 2007, position-based
  // collisions).
  double floor = -std::numeric_limits<double>::infinity();
};

struct NewtonOptions {
  double tolerance = 1e-3;  // on |gradient| / |weight|, friction at the true normal forces
  int most_steps = 300;
  Holding holding = Holding::anchored;
  std::optional<SpringSteps> springs = {};
  // full: where the Hessian is not positive definite it is clamped; where that gets on slowly, its bending part counts several
  // times instead. clamped: projected Newton, the reference.
  Curvature curvature = Curvature::full;
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
