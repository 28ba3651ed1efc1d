#include "drape/fem/newton.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "collide/intersections.h"
#include "collide/truncation.h"
#include "drape/fem/assembly.h"

namespace toile::fem {
namespace {

constexpr double steady_move = 1e-3;       // m, longest of a step after which the Hessian is much the same
constexpr double first_stiffening = 0.1;   // of the bending part of the Hessian
constexpr double more_stiffening = 4;      // times as much when it is not enough
constexpr double less_stiffening = 0.5;    // after a step in full
constexpr int most_stiffenings = 3;        // in one step
constexpr double slow_progress = 0.9;      // of the residual left after a step
constexpr int patience = 3;                // slow steps
constexpr double longest_way_out = 10e-3;  // m
constexpr double rounding_errors = 32;     // of the energy: near rest a step gains less than it can be told by
constexpr double near_margin = 3e-3;       // m, of movement before the list of near pairs is made anew

// Positions, and what is known there.
struct State {
  Eigen::Matrix3Xd x;
  std::vector<Touch> touches;
  double lasting = 0;  // J
};

State state_at(const Model& model, const Frozen& frozen, Eigen::Matrix3Xd x) {
  std::vector<Touch> touches = touching(model, x);
  const double lasting = lasting_energy(model, frozen, x, touches);
  return {std::move(x), std::move(touches), lasting};
}

// Moves what `to` presses closer than `floor` m to the body, and closer than `from` does, back out.
void keep_out(const Model& model, const Eigen::Matrix3Xd& from, double floor, Eigen::Matrix3Xd& to) {
  for (const Touch& touch : touching(model, to)) {
    if (touch.body.distance >= floor) continue;
    const double before = model.body->distance.distance(place_of(*touch.spot, from));
    const DistanceSample body = model.body->distance.sample(place_of(*touch.spot, to));  // others have moved it since
    const double in = std::min(before, floor) - body.distance, steepness = body.gradient.squaredNorm();
    if (in <= 0 || steepness < 1e-6) continue;
    const Eigen::Vector3d out = std::min(in, longest_way_out) / steepness * body.gradient;
    for (const int v : corners_of(*touch.spot)) to.col(v) += out;
  }
}

// Largest fraction of `step`, halving, that lowers the energy enough (Armijo), and the state there; zero when none does.
std::pair<double, State> line_search(const Model& model, const Frozen& frozen, const State& from, const Eigen::Matrix3Xd& step,
                                     double slope, const std::optional<SpringSteps>& springs) {
  const double before = from.lasting + lagged_energy(model, frozen, from.x);
  const double rounding = rounding_errors * std::numeric_limits<double>::epsilon() * std::abs(before);
  double fraction = 1;
  for (int halvings = 0; halvings < 25; ++halvings, fraction /= 2) {
    Eigen::Matrix3Xd at = from.x + fraction * step;
    if (springs) keep_out(model, from.x, springs->floor, at);
    State to = state_at(model, frozen, std::move(at));
    if (to.lasting + lagged_energy(model, frozen, to.x) <= before + 1e-4 * fraction * slope + rounding)
      return {fraction, std::move(to)};
  }
  return {0, from};
}

// Gradient with the lagged normal forces, which Newton minimises with, and the residual with the true ones, which counts.
struct Forces {
  Eigen::Matrix3Xd lagged;
  double residual = 0;
};

// Square of what is left of `force`, N^2, when friction of a vertex takes up as much as its normal force lets it.
double out_of_cone(double friction, const FrictionState& state, const Eigen::Vector3d& force) {
  const double across = force.dot(state.normal);
  const double along = std::max(0.0, (force - across * state.normal).norm() - friction * state.force);
  return across * across + along * along;
}

// `normal`: the true forces; `frozen` has the normals of x.
Forces forces_at(const Model& model, const Frozen& frozen, const State& state, const Eigen::VectorXd& normal, Holding holding) {
  Forces forces{lasting_gradient(model, frozen, state.x, state.touches), 0};
  add_self_contact(frozen.self, state.x, forces.lagged);
  double square = 0;
  for (Eigen::Index v = 0; v < state.x.cols(); ++v) {
    FrictionState friction = frozen.vertex[static_cast<std::size_t>(v)];
    const Eigen::Vector3d lagged = friction_gradient(model.contact, friction, state.x.col(v));
    friction.force = normal(v);
    square += holding == Holding::cone
                  ? out_of_cone(model.contact.friction, friction, forces.lagged.col(v))
                  : (forces.lagged.col(v) + friction_gradient(model.contact, friction, state.x.col(v))).squaredNorm();
    forces.lagged.col(v) += lagged;
  }
  forces.residual = std::sqrt(square) / weight(model);
  return forces;
}

// Keeps cloth that does not pass through itself from doing so. Cloth that does from the start is left to itself.
class Untouched {
 public:
  Untouched(const Model& model, const Eigen::Matrix3Xd& start)
      : crossings_(model.cloth.triangles, near_margin),
        free_(!crossings_.any(start)),
        near_(model.cloth, truncation_reach, truncation_reach / 2) {}

  // Nothing when the cloth may go to `to`, else as far towards it as every part may go without passing through another.
  std::optional<Eigen::Matrix3Xd> held(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
    if (!free_ || !crossings_.any(to)) return {};
    Eigen::Matrix3Xd x = from;
    Truncation(from, near_).advance(x, to);
    return x;
  }

 private:
  static constexpr double truncation_reach = 8e-3;  // m
  IntersectionSearch crossings_;
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
  State state = state_at(model, frozen, start);
  sample_touching(model, state.touches);
  Forces forces = forces_at(model, frozen, state, normal_forces(model, state.touches), options.holding);
  Equilibrium best{start, forces.residual, 0, false};
  double dt = options.first_dt;
  const HessianAssembly* factorised_last = nullptr;
  bool factor_serves = false;  // the last step with it was small and did well: another one costs a solution only
  double share = options.least_force_share;
  double stiffening = 0;
  int slow_steps = 0;  // in a row; patience: clamped steps have come to a plateau, on which cloth that buckles creeps
  for (int step = 1; step <= options.most_steps && best.residual > options.tolerance && !out_of_time(); ++step) {
    HessianAssembly& assembly = pattern.fit(frozen.self);
    const auto factorised = [&](Curvature curvature) {
      assemble(model, frozen, state.x, state.touches, curvature, assembly);
      for (Eigen::Index v = 0; v < model.mass.size(); ++v)
        assembly.matrix.add_diagonal(static_cast<int>(v), model.mass(v) / (dt * dt));
      return assembly.matrix.factorise();
    };
    const auto full_or_stiffened = [&] {
      for (int i = 0; i <= most_stiffenings; ++i) {
        assembly.bending_share = 1 + stiffening;
        if (factorised(Curvature::full)) return true;
        stiffening = std::max(stiffening * more_stiffening, first_stiffening);
      }
      return false;
    };
    const auto factorised_well = [&] {
      if (options.springs)
        return (forces.residual <= options.springs->clamped_above && full_or_stiffened()) || factorised(Curvature::clamped);
      assembly.bending_share = 1;
      if (factorised(options.curvature)) {
        slow_steps = 0;
        return true;
      }
      return (slow_steps >= patience && options.curvature == Curvature::full && full_or_stiffened()) ||
             factorised(Curvature::clamped);
    };
    const bool as_before = factor_serves && factorised_last == &assembly;
    if (!as_before && !factorised_well()) {
      dt /= 4;
      factor_serves = false;
      continue;
    }
    factorised_last = &assembly;
    Eigen::Matrix3Xd move = -assembly.matrix.solve(forces.lagged);
    const double longest = move.colwise().norm().maxCoeff();
    if (longest > options.step_cap) move *= options.step_cap / longest;
    auto [fraction, reached] = line_search(model, frozen, state, move, forces.lagged.cwiseProduct(move).sum(), options.springs);
    if (auto held = untouched.held(state.x, reached.x)) reached = state_at(model, frozen, std::move(*held));
    predict_pull(model, state.x, reached.x, frozen);
    if (fraction < 0.5)
      stiffening = std::max(stiffening * more_stiffening, first_stiffening);
    else if (fraction == 1 && !as_before)
      stiffening *= less_stiffening;
    state = std::move(reached);
    sample_touching(model, state.touches);
    const Eigen::VectorXd normal = normal_forces(model, state.touches);
    dt = fraction > 0.2 ? std::min(dt * options.growth, options.most_dt) : std::max(dt / 2, 1e-3);
    update_friction(model, state.x, normal, share, frozen);
    frozen.self = self_contact_at(model, near, state.x);
    const double before = forces.residual;
    forces = forces_at(model, frozen, state, normal, options.holding);
    if (slow_steps < patience) slow_steps = forces.residual > slow_progress * before ? slow_steps + 1 : 0;
    factor_serves = fraction == 1 && longest < steady_move && forces.residual < before / 2;
    share = forces.residual < before ? std::min(share * 1.25, options.most_force_share)
                                     : std::max(share / 2, options.least_force_share);
    if (options.progress) options.progress(step, forces.residual);
    best.steps = step;
    if (forces.residual < best.residual) {
      best.x = state.x;
      best.residual = forces.residual;
    }
  }
  best.settled = best.residual <= options.tolerance;
  return best;
}

}  // namespace toile::fem
