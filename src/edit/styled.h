#pragma once
// A shape the style energy was solved for, judged against its source.

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "edit/body_terms.h"
#include "edit/edit_memory.h"
#include "garment/target.h"
#include "style/normal_deviation.h"

namespace toile {

struct Styled {
  Eigen::Matrix3Xd positions;
  StyleTerms before, after;   // at the initial guess, at the end
  NormalDeviation deviation;  // of the triangles that moved
  double deepest = 0;         // m, how much deeper than it may a vertex is inside the body
  bool settled = false;
};

// `reference`: the source's triangles, whose planes are to be kept. `gap`: m by vertex, what each had in the source.
Styled styled(const Body& body, const BodyTerms& terms, const std::vector<SourceTriangle>& reference,
              const Eigen::Matrix3Xd& source, const Eigen::VectorXd& gap, const Eigen::Matrix3Xd& initial,
              const StyleSolution& solution);

// Triangles of `shape` that are turned over laid anew where that can be done by moving what lies about them; vertices that
// `hard` names stay.
void mend(Styled& shape, const Body& body, const std::vector<SourceTriangle>& reference, const Eigen::Matrix3Xd& source,
          const Eigen::VectorXd& gap, const HardConstraints& hard);

// Strengths of the pull towards the initial guess that are tried in turn.
constexpr std::array<double, 4> pulls{0.02, 0.1, 0.3, 0.6};

// No triangle turned over, and none more than twice as long or half as long as it was.
bool is_even(const NormalDeviation& deviation);
// No triangle turned over where the other has some; else stretched more evenly.
bool is_better(const NormalDeviation& one, const NormalDeviation& other);

// What `solve` gives for the weakest pull towards the initial guess, not below `least`, with which the result is even and the
// solve settles; failing that the best.
Styled with_weakest_pull(const std::function<Styled(const StyleOptions&)>& solve, double least = 0);

// A source to be given another shape; `gap` as above.
struct Restyling {
  const Body& body;
  const Eigen::Matrix3Xd& source;
  const std::vector<SourceTriangle>& triangles;
  const Eigen::VectorXd& gap;
  Eigen::Matrix3Xd guess;
  HardConstraints hard;
  BodyTerms terms;
};

// With the weakest pull; where the memory knows of an earlier restyling of this `name`, by following its solution, if that
// turns no triangle over. The name says all but amounts.
Styled restyled(const Restyling& restyling, EditMemory& memory, const std::string& name);

}  // namespace toile
