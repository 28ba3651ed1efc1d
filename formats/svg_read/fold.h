#pragma once
// Where a half piece lies on the fold of the cloth.

#include <optional>
#include <string>
#include <vector>

#include "formats/svg_read/grouping.h"

namespace toile::svg {

struct Fold {
  Eigen::Vector2d from = Eigen::Vector2d::Zero(), to = Eigen::Vector2d::Zero();
  bool drawn = false;  // by a line or bracket; otherwise told by a text
};

// The straight edge of `outline` (with its corners) that the fold line or bracket among `lines` marks.
std::optional<Fold> drawn_fold(const Ring& outline, const std::vector<const DrawnLine*>& fold_lines);

// The straight edge a piece that is "cut on the fold" lies on, when no line marks it: square at both ends, and either the only
// one without allowance (`cut` runs along it), or nearest to where the text `at` says so, or the longest by far.
std::optional<Fold> told_fold(const Ring& outline, const std::optional<Points<2>>& cut,
                              const std::optional<Eigen::Vector2d>& at);

}  // namespace toile::svg
