#include "drape/fem/newton.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "collide/intersections.h"
#include "collide/truncation.h"

namespace toile::fem {
namespace {

constexpr double near_margin = 3e-3;  // m, of movement before the list of near pairs is made anew

// Largest fraction of `step`, halving, that lowers the energy enough (Armijo); zero when none does.
double line_search(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& step,
                   double slope) {
  const double before = energy(model, frozen, x);
  double fraction = 1;
  for (int halvings = 0; halvings < 25; ++halvings, fraction /= 2)
    if (energy(model, frozen, x + fraction * step) <= before + 1e-4 * fraction * slope) return fraction;
  return 0;
}

// Gradient with the lagged normal forces, which Newton minimises with, and the residual with the true ones, which counts.
struct Forces {
  Eigen::Matrix3Xd lagged;
  double residual = 0;
};

Forces forces_at(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x) {
  Forces forces{gradient_without_friction(model, x), 0};
  add_self_contact(frozen.self, x, forces.lagged);
  Eigen::Matrix3Xd exact = forces.lagged;
  Frozen true_friction = frozen;
  update_friction(model, x, 1, true_friction);
  add_friction(model, true_friction, x, exact);
  add_friction(model, frozen, x, forces.lagged);
  forces.residual = exact.norm() / weight(model);
  return forces;
}

// Keeps cloth that does not pass through itself from doing so. Cloth that does from the start is left to itself.
class Untouched {
 public:
  Untouched(const Model& model, const Eigen::Matrix3Xd& start)
      : triangles_(model.cloth.triangles),
        free_(intersecting_triangles(start, triangles_).empty()),
        near_(model.cloth, truncation_reach, truncation_reach / 2) {}

  // `to`, or, when that would pass the cloth through itself, as far towards it as every part may go by itself.
  Eigen::Matrix3Xd moved(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
    if (!free_ || intersecting_triangles(to, triangles_).empty()) return to;
    Eigen::Matrix3Xd x = from;
    Truncation(from, near_).advance(x, to);
    return x;
  }

 private:
  static constexpr double truncation_reach = 8e-3;  // m
  const Eigen::Matrix3Xi& triangles_;
  bool free_;
  NearPairSearch near_;
};

// The Hessian's pattern, which grows as the cloth comes to touch itself elsewhere.
class Pattern {
 public:
  explicit Pattern(const Model& model) : model_(model), assembly_(make_assembly(model)) {}
  HessianAssembly& fit(const SelfContact& self) {
    bool grown = false;
    for (auto [a, b] : coupled_vertices(self)) {
      if (a > b) std::swap(a, b);
      if (assembly_->matrix.has(a, b)) continue;
      extra_.emplace_back(a, b);
      grown = true;
    }
    if (grown) assembly_ = make_assembly(model_, extra_);
    return *assembly_;
  }

 private:
  const Model& model_;
  std::vector<std::pair<int, int>> extra_;
  std::unique_ptr<HessianAssembly> assembly_;
};

}  // namespace

Equilibrium find_equilibrium(const Model& model, const Eigen::Matrix3Xd& start, const NewtonOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  const auto out_of_time = [&] {
    if (options.stop && options.stop()) return true;
    return options.time_limit &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() > *options.time_limit;
  };
  Pattern pattern(model);
  Untouched untouched(model, start);
  Frozen frozen = frozen_at(model, start);
  NearPairSearch near(model.cloth, frozen.self.law.reach, near_margin);
  frozen.self = self_contact_at(model, near, start);
  Eigen::Matrix3Xd x = start;
  Forces forces = forces_at(model, frozen, x);
  Equilibrium best{start, forces.residual, 0, false};
  double dt = options.first_dt;
  double share = options.least_force_share;
  for (int step = 1; step <= options.most_steps && best.residual > options.tolerance && !out_of_time(); ++step) {
    HessianAssembly& assembly = pattern.fit(frozen.self);
    const auto factorised = [&](Curvature curvature) {
      assemble(model, frozen, x, curvature, assembly);
      for (Eigen::Index v = 0; v < model.mass.size(); ++v)
        assembly.matrix.add_diagonal(static_cast<int>(v), model.mass(v) / (dt * dt));
      return assembly.matrix.factorise();
    };
    if (!factorised(options.curvature) && !factorised(Curvature::clamped)) {
      dt /= 4;
      continue;
    }
    Eigen::Matrix3Xd move = -assembly.matrix.solve(forces.lagged);
    const double longest = move.colwise().norm().maxCoeff();
    if (longest > options.step_cap) move *= options.step_cap / longest;
    const double fraction = line_search(model, frozen, x, move, forces.lagged.cwiseProduct(move).sum());
    x = untouched.moved(x, x + fraction * move);
    dt = fraction > 0.2 ? std::min(dt * options.growth, options.most_dt) : std::max(dt / 2, 1e-3);
    update_friction(model, x, share, frozen);
    frozen.self = self_contact_at(model, near, x);
    const double before = forces.residual;
    forces = forces_at(model, frozen, x);
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
