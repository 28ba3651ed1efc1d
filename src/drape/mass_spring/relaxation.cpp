#include "drape/mass_spring/relaxation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "drape/mass_spring/body_contact.h"

namespace toile::mass_spring {
namespace {

constexpr double courant = 0.5;           // share of the stable step
constexpr double longest_step = 0.25e-3;  // m, of a vertex in one step
constexpr double limit_share = 3;         // of the fabric's limit, which no spring may pass in one step
constexpr int steps_between_weighings = 10;
constexpr int steps_between_looks = 50;

// Where the state of motion can be judged: a shape, with its forces.
struct Moving {
  Eigen::Matrix3Xd x, velocity;
  Forces forces;
  Eigen::VectorXd contact_stiffness;
  Eigen::VectorXd inertia;  // kg by vertex: as much in all as the cloth has, but spread so that all steps are equally stable
};

void update_forces(const Cloth& cloth, BodyContact& contact, double longest_move, Moving& now) {
  contact.update(longest_move, now.x, now.forces.push, now.contact_stiffness);
  now.forces.total = now.forces.push;
  add_inner_forces(cloth, now.x, now.forces.total);
}

// Takes from the two ends of every spring that would be stretched beyond the limit the speed that does it.
void limit_strain(const Cloth& cloth, double dt, Moving& now) {
  const double limit = limit_share * cloth.law.limit;
  const double most = 1 + 2 * limit;
  for (const Spring& spring : cloth.springs) {
    const Eigen::Vector3d along = now.x.col(spring.b) - now.x.col(spring.a);
    if (along.squaredNorm() < 0.9 * most * spring.rest * spring.rest) continue;
    const Eigen::Vector3d next = along + dt * (now.velocity.col(spring.b) - now.velocity.col(spring.a));
    const double length = next.norm(), allowed = std::max(std::sqrt(most) * spring.rest, along.norm());
    if (length <= allowed) continue;
    const double ia = 1 / now.inertia(spring.a), ib = 1 / now.inertia(spring.b);
    const Eigen::Vector3d change = (length - allowed) / (dt * length * (ia + ib)) * next;
    now.velocity.col(spring.a) += ia * change;
    now.velocity.col(spring.b) -= ib * change;
  }
}

void rub(const Cloth& cloth, double dt, Moving& now) {
  for (Eigen::Index v = 0; v < now.x.cols(); ++v) {
    const double push = now.forces.push.col(v).norm();
    if (push <= 0) continue;
    const Eigen::Vector3d normal = now.forces.push.col(v) / push;
    const double across = normal.dot(now.velocity.col(v));
    const Eigen::Vector3d along = now.velocity.col(v) - across * normal;
    const double speed = along.norm(), lost = cloth.contact.friction * push * dt / now.inertia(v);
    now.velocity.col(v) = across * normal;
    if (speed > lost) now.velocity.col(v) += (1 - lost / speed) * along;
  }
}

}  // namespace

Rest relax(const Cloth& cloth, const Eigen::Matrix3Xd& start, const RelaxationOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  const auto out_of_time = [&] {
    if (options.stop && options.stop()) return true;
    return options.time_limit &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count() > *options.time_limit;
  };
  BodyContact contact(cloth);
  Moving now;
  now.x = start;
  now.velocity = Eigen::Matrix3Xd::Zero(3, start.cols());
  update_forces(cloth, contact, 0, now);
  const double dt = 2 * courant * std::sqrt(cloth.mass.sum() / rest_row_sum(cloth));
  const double inertia_per_stiffness = dt * dt / (4 * courant * courant);

  Rest best{start, static_residual(cloth, now.forces), 0, false};
  Eigen::Matrix3Xd at_window = start;
  Eigen::VectorXd stiffness;
  Eigen::Matrix3Xd before;
  double window_began = 0;
  int since_stop = 0;
  const int most_steps = static_cast<int>(options.longest / dt);
  for (int step = 1; step <= most_steps; ++step) {
    if (step % steps_between_weighings == 1) stiffness = row_sums(cloth, now.x);
    now.inertia = inertia_per_stiffness * (stiffness + now.contact_stiffness);
    now.velocity *= static_cast<double>(since_stop) / (since_stop + 3);
    before = now.velocity;
    for (Eigen::Index v = 0; v < now.x.cols(); ++v) now.velocity.col(v) += dt / now.inertia(v) * now.forces.total.col(v);
    limit_strain(cloth, dt, now);
    rub(cloth, dt, now);
    double fastest = 0, power = 0;
    for (Eigen::Index v = 0; v < now.x.cols(); ++v) {
      double speed = now.velocity.col(v).norm();
      if (speed * dt > longest_step) {
        now.velocity.col(v) *= longest_step / (speed * dt);
        speed = longest_step / dt;
      }
      fastest = std::max(fastest, speed);
      power += now.inertia(v) * before.col(v).dot(now.velocity.col(v) - before.col(v));
    }
    now.x += dt * now.velocity;
    update_forces(cloth, contact, fastest * dt, now);
    ++since_stop;
    if (power < 0) {
      now.velocity.setZero();
      since_stop = 0;
    }

    best.steps = step;
    if (step % steps_between_looks != 0) continue;
    const double residual = static_residual(cloth, now.forces);
    if (options.progress) options.progress(step, residual);
    if (residual < best.residual) {
      best.x = now.x;
      best.residual = residual;
    }
    if (out_of_time()) break;
    if (step * dt - window_began < options.window) continue;
    const bool still = (now.x - at_window).colwise().norm().maxCoeff() < options.still;
    if (still && residual <= options.tolerance) {
      best.x = now.x;
      best.residual = residual;
      best.settled = true;
      break;
    }
    at_window = now.x;
    window_began = step * dt;
  }
  return best;
}

}  // namespace toile::mass_spring
