#include "style/style_solve.h"

#include "style/style_iteration.h"
#include "style/style_system.h"

namespace toile {

StyleSolution solve_style(const Eigen::Matrix3Xd& guess, const std::vector<SourceTriangle>& triangles,
                          const HardConstraints& constraints, const SoftTermsAt& soft_terms, const StyleOptions& options,
                          StyleMemory* memory) {
  StyleSolution solution;
  StyleSystem system(triangles, constraints, guess.cols(), memory);
  if (soft_terms) solution.soft = soft_terms(guess, 0);
  system.factor(solution.soft);
  solution.initial = system.solve_near(guess);
  StyleIteration iteration(triangles, system, solution.initial, options);
  const auto iterate = [&](int most) {
    for (int k = 0; k < most; ++k) {
      ++solution.iterations;
      if (iteration.step() < options.tolerance) return true;
    }
    return false;
  };
  solution.settled = iterate(options.most_iterations);
  for (int round = 1; soft_terms && round <= options.most_rounds; ++round) {
    solution.soft = soft_terms(iteration.x(), round);
    if (solution.soft.empty() && round == 1) break;
    const Eigen::Matrix3Xd before = iteration.x();
    system.factor(solution.soft);
    solution.settled = iterate(options.round_iterations);
    solution.rounds = round;
    if ((iteration.x() - before).colwise().norm().maxCoeff() < options.tolerance) break;
    if (round == options.most_rounds) solution.settled = false;
  }
  solution.positions = iteration.x();
  return solution;
}

StyleReference style_reference(const StyleSolution& solution, const std::vector<SourceTriangle>& triangles,
                               const HardConstraints& constraints, const SoftTermsAt& soft_terms, const StyleOptions& options,
                               StyleMemory* memory) {
  StyleSystem system(triangles, constraints, solution.positions.cols(), memory);
  StyleIteration iteration(triangles, system, solution.initial, options);
  iteration.go_to(solution.positions);
  return {solution.positions, solution.initial,
          iteration.imbalance(soft_terms ? soft_terms(solution.positions, 1) : std::vector<SoftTerm>{}), options};
}

StyleSolution follow_style(const StyleReference& reference, const Eigen::Matrix3Xd& guess,
                           const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints,
                           const SoftTermsAt& soft_terms, StyleMemory* memory) {
  StyleSolution solution;
  StyleSystem system(triangles, constraints, guess.cols(), memory);
  if (soft_terms) solution.soft = soft_terms(guess, 0);
  system.factor(solution.soft);
  solution.initial = system.solve_near(guess);
  StyleIteration iteration(triangles, system, solution.initial, reference.options);
  iteration.go_to(reference.positions + solution.initial - reference.initial);
  while (!solution.settled && solution.rounds < reference.options.most_steps) {
    ++solution.rounds;
    if (soft_terms) solution.soft = soft_terms(iteration.x(), solution.rounds);
    solution.settled = iteration.step_directly(solution.soft, reference.imbalance) < reference.options.tolerance;
    ++solution.iterations;
  }
  solution.positions = iteration.x();
  return solution;
}

}  // namespace toile
