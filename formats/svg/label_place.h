#pragma once
// Where a block of text fits best inside a piece.

#include <Eigen/Core>
#include <string_view>
#include <utility>
#include <vector>

namespace toile {

struct LabelPlace {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  bool upright = true;  // false: turned a quarter so that it reads from below to above
  double scale = 0;     // 0: fits nowhere
};

using Segment2 = std::pair<Eigen::Vector2d, Eigen::Vector2d>;

// The largest scale up to `largest` at which a block of width x height fits inside the closed `outline` clear of `obstacles`;
// among equals the place nearest to the middle; turned only where that gains a third.
LabelPlace place_label(const std::vector<Eigen::Vector2d>& outline, const std::vector<Segment2>& obstacles, double width,
                       double height, double largest);

// A generous estimate of the width of `words` in letters of size 1.
double text_width(std::string_view words);

}  // namespace toile
