#include "drape/fem/newton.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace toile::fem {
namespace {

// Largest fraction of `step`, halving, that lowers the energy enough (Armijo); zero when none does.
double line_search(const Model& model, const Friction& friction, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& step,
                   double slope) {
  const double before = energy(model, friction, x);
  double fraction = 1;
  for (int halvings = 0; halvings < 25; ++halvings, fraction /= 2)
    if (energy(model, friction, x + fraction * step) <= before + 1e-4 * fraction * slope) return fraction;
  return 0;
}

// Gradient with the lagged normal forces, which Newton minimises with, and the residual with the true ones, which counts.
struct Forces {
  Eigen::Matrix3Xd lagged;
  double residual = 0;
};

Forces forces_at(const Model& model, const Friction& friction, const Eigen::Matrix3Xd& x) {
  Forces forces{gradient_without_friction(model, x), 0};
  Eigen::Matrix3Xd exact = forces.lagged;
  Friction true_friction = friction;
  update_friction(model, x, 1, true_friction);
  add_friction(model, true_friction, x, exact);
  add_friction(model, friction, x, forces.lagged);
  forces.residual = exact.norm() / weight(model);
  return forces;
}

}  // namespace

Equilibrium find_equilibrium(const Model& model, const Eigen::Matrix3Xd& start, const NewtonOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  const auto out_of_time = [&] {
    return options.time_limit &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() > *options.time_limit;
  };
  const std::unique_ptr<HessianAssembly> assembly = make_assembly(model);
  Friction friction = start_friction(model, start);
  Eigen::Matrix3Xd x = start;
  Forces forces = forces_at(model, friction, x);
  Equilibrium best{start, forces.residual, 0, false};
  double dt = options.first_dt;
  double share = options.least_force_share;
  for (int step = 1; step <= options.most_steps && best.residual > options.tolerance && !out_of_time(); ++step) {
    const auto factorised = [&](Curvature curvature) {
      assemble(model, friction, x, curvature, *assembly);
      for (Eigen::Index v = 0; v < model.mass.size(); ++v)
        assembly->matrix.add_diagonal(static_cast<int>(v), model.mass(v) / (dt * dt));
      return assembly->matrix.factorise();
    };
    if (!factorised(options.curvature) && !factorised(Curvature::clamped)) {
      dt /= 4;
      continue;
    }
    Eigen::Matrix3Xd move = -assembly->matrix.solve(forces.lagged);
    const double longest = move.colwise().norm().maxCoeff();
    if (longest > options.step_cap) move *= options.step_cap / longest;
    const double fraction = line_search(model, friction, x, move, forces.lagged.cwiseProduct(move).sum());
    x += fraction * move;
    dt = fraction > 0.2 ? std::min(dt * options.growth, options.most_dt) : std::max(dt / 2, 1e-3);
    update_friction(model, x, share, friction);
    const double before = forces.residual;
    forces = forces_at(model, friction, x);
    share = forces.residual < before ? std::min(share * 1.25, options.most_force_share)
                                     : std::max(share / 2, options.least_force_share);
    if (options.progress) options.progress(step, forces.residual);
    best.steps = step;
    if (forces.residual < best.residual) {
      best.x = x;
      best.residual = forces.residual;
    }
  }
  best.settled = best.residual <= options.tolerance;
  return best;
}

}  // namespace toile::fem
