#include "style/style_iteration.h"

#include <Eigen/Dense>
#include <algorithm>

#include "parallel/threads.h"

namespace toile {

StyleIteration::StyleIteration(const std::vector<SourceTriangle>& triangles, StyleSystem& system,
                               const Eigen::Matrix3Xd& initial, const StyleOptions& options)
    : triangles_(triangles),
      system_(system),
      options_(options),
      x_(initial),
      maps_(triangles.size(), Eigen::Matrix2d::Identity()),
      first_(maps_),
      bounds_(triangles.size(), {options.least_stretch, options.most_stretch}) {
  // The constraints themselves may need more stretch than the clamp allows; it must not fight them.
  for (const std::size_t t : system.moving()) {
    first_[t] = plane_map_of(triangles[t], initial);
    const Eigen::Vector2d values = signed_singular_values(first_[t]);
    if (values(1) > 0) bounds_[t].least = std::min(options.least_stretch, 0.8 * values(1));
    bounds_[t].most = std::max(options.most_stretch, 1.25 * values(0));
  }
}

Eigen::Matrix2d StyleIteration::drawn_to(std::size_t t) const {
  return (1 - options_.in_plane_pull) * clamped(plane_map_of(triangles_[t], x_), bounds_[t].least, bounds_[t].most) +
         options_.in_plane_pull * first_[t];
}

double StyleIteration::move_to(const Eigen::Matrix3Xd& next) {
  const double move = (x_ - next).colwise().norm().maxCoeff();
  x_ = next;
  return move;
}

double StyleIteration::step() {
  const std::vector<std::size_t>& moving = system_.moving();
  in_ranges(8, static_cast<int>(moving.size()), [&](int, int begin, int end) {
    for (int i = begin; i < end; ++i)
      maps_[moving[static_cast<std::size_t>(i)]] = drawn_to(moving[static_cast<std::size_t>(i)]);
  });
  return move_to(system_.solve(maps_));
}

double StyleIteration::step_directly(const std::vector<SoftTerm>& soft, const Eigen::Matrix3Xd& force) {
  std::vector<double> stiffness(triangles_.size(), options_.in_plane_pull);
  for (const std::size_t t : system_.moving()) {
    const Eigen::Vector2d values = signed_singular_values(plane_map_of(triangles_[t], x_));
    const bool inside = values(1) >= bounds_[t].least && values(0) <= bounds_[t].most;
    stiffness[t] = inside ? options_.in_plane_pull : 1;
    maps_[t] = inside ? first_[t] : drawn_to(t);
  }
  return move_to(system_.solve_directly(soft, stiffness, maps_, force));
}

Eigen::Matrix3Xd StyleIteration::imbalance(const std::vector<SoftTerm>& soft) const {
  std::vector<Eigen::Matrix2d> maps(triangles_.size(), Eigen::Matrix2d::Identity());
  for (const std::size_t t : system_.moving()) maps[t] = drawn_to(t);
  Eigen::Matrix3Xd force = shape_gradient(triangles_, maps, x_) / 2;
  for (const SoftTerm& term : soft)
    force.col(term.vertex) += term.weight * (term.direction.dot(x_.col(term.vertex)) - term.goal) * term.direction;
  return force;
}

}  // namespace toile
