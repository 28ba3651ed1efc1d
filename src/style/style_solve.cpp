#include "style/style_solve.h"

#include <algorithm>

#include "style/style_system.h"

namespace toile {
namespace {

struct MapBounds {
  double least, most;
};

double largest_move(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  return (to - from).colwise().norm().maxCoeff();
}

}  // namespace

StyleSolution solve_style(const Eigen::Matrix3Xd& guess, const std::vector<SourceTriangle>& triangles,
                          const HardConstraints& constraints, const SoftTermsAt& soft_terms, const StyleOptions& options) {
  StyleSolution solution;
  StyleSystem system(triangles, constraints, guess.cols());
  const auto terms_at = [&](const Eigen::Matrix3Xd& x, int round) {
    return soft_terms ? soft_terms(x, round) : std::vector<SoftTerm>{};
  };
  solution.soft = terms_at(guess, 0);
  system.factor(solution.soft);
  solution.initial = system.solve_near(guess);
  solution.positions = solution.initial;

  // The constraints themselves may need more stretch than the clamp allows; it must not fight them.
  std::vector<Eigen::Matrix2d> maps(triangles.size(), Eigen::Matrix2d::Identity()), first = maps;
  std::vector<MapBounds> bounds(triangles.size(), {options.least_stretch, options.most_stretch});
  for (const std::size_t t : system.moving()) {
    first[t] = plane_map_of(triangles[t], solution.initial);
    const Eigen::Vector2d values = signed_singular_values(first[t]);
    if (values(1) > 0) bounds[t].least = std::min(options.least_stretch, 0.8 * values(1));
    bounds[t].most = std::max(options.most_stretch, 1.25 * values(0));
  }

  const auto iterate = [&](int most) {
    for (int k = 0; k < most; ++k) {
      for (const std::size_t t : system.moving())
        maps[t] = (1 - options.in_plane_pull) *
                      clamped(plane_map_of(triangles[t], solution.positions), bounds[t].least, bounds[t].most) +
                  options.in_plane_pull * first[t];
      const Eigen::Matrix3Xd next = system.solve(maps);
      const double move = largest_move(solution.positions, next);
      solution.positions = next;
      ++solution.iterations;
      if (move < options.tolerance) return true;
    }
    return false;
  };
  solution.settled = iterate(options.most_iterations);
  for (int round = 1; soft_terms && round <= options.most_rounds; ++round) {
    solution.soft = terms_at(solution.positions, round);
    if (solution.soft.empty() && round == 1) break;
    const Eigen::Matrix3Xd before = solution.positions;
    system.factor(solution.soft);
    solution.settled = iterate(options.round_iterations);
    solution.rounds = round;
    if (largest_move(before, solution.positions) < options.tolerance) break;
    if (round == options.most_rounds) solution.settled = false;
  }
  return solution;
}

}  // namespace toile
