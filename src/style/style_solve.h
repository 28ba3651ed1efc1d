#pragma once
// The garment shape that keeps the source's style while hard constraints hold: iterated quadratic minimisation of the style
// energy.

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "style/hard_constraints.h"
#include "style/soft_terms.h"
#include "style/source_shape.h"
#include "style/style_memory.h"

namespace toile {

struct StyleOptions {
  double in_plane_pull = 0.02;  // beta: how much of the initial guess's in-plane map is kept in every iteration
  double least_stretch = 0.5;   // in-plane maps are clamped to these, or to what the initial guess itself needs
  double most_stretch = 2;
  double tolerance = 1e-4;    // m, largest move in one iteration
  int most_iterations = 30;   // before the first look at the body
  int round_iterations = 10;  // after every further one
  int most_rounds = 6;
  int most_steps = 4;  // of follow_style
};

// Soft terms for a shape; asked again in every round, because skin slides under a moving garment.
using SoftTermsAt = std::function<std::vector<SoftTerm>(const Eigen::Matrix3Xd& x, int round)>;

struct StyleSolution {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xd initial;    // the harmonic correction of the guess, where it started
  std::vector<SoftTerm> soft;  // as of the last round
  int iterations = 0;
  int rounds = 0;
  bool settled = false;  // the last iteration and the last round moved nothing by more than the tolerance
};

// Starts from the harmonic displacement (least sum A |grad(x - source)|^2 under the same constraints): the energy has a large
// null space, so what is not penalised is as smooth as the start. `source` is 3 x n; every connected part must be constrained,
// or std::invalid_argument is thrown. `memory` of earlier solves saves work and changes nothing.
StyleSolution solve_style(const Eigen::Matrix3Xd& source, const std::vector<SourceTriangle>& triangles,
                          const HardConstraints& constraints, const SoftTermsAt& soft_terms = {},
                          const StyleOptions& options = {}, StyleMemory* memory = nullptr);

// A shape that was solved for, from which others are found whose constraints or goals differ a little.
struct StyleReference {
  Eigen::Matrix3Xd positions, initial;
  Eigen::Matrix3Xd imbalance;  // 3 x n, what the solve left when it was cut off
  StyleOptions options;
};

// Of what solve_style gave for these arguments. `soft_terms` go on from there.
StyleReference style_reference(const StyleSolution& solution, const std::vector<SourceTriangle>& triangles,
                               const HardConstraints& constraints, const SoftTermsAt& soft_terms, const StyleOptions& options,
                               StyleMemory* memory = nullptr);

// The shape under other constraints on the same freedoms, or other goals, that keeps the reference's imbalance: the reference
// itself when nothing is other. Newton's method from the reference on, a few steps where solve_style takes many; it ends where
// solve_style does as nearly as the ends of both solves are alike. Every solution depends on the reference and its own
// arguments alone.
StyleSolution follow_style(const StyleReference& reference, const Eigen::Matrix3Xd& guess,
                           const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints,
                           const SoftTermsAt& soft_terms = {}, StyleMemory* memory = nullptr);

}  // namespace toile
