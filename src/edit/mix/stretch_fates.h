#pragma once
// What becomes of each stretch of a joint: no seam any more, or a seam and why.

#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "edit/mix/joint_stretch.h"
#include "garment/report.h"

namespace toile {

// Mean distortion of laying a piece flat beyond which it is not developable: the adjustment's own limit
// (AdjustOptions::developable_limit).
inline constexpr double developable_limit = 0.02;
// Two edges that turn apart by K bend the cloth beside them by K / 2 each; a line of length L is felt to a depth of L / pi, so
// the strain along it comes to K / (4 pi). This is where that reaches the limit: 14 degrees.
inline constexpr double flat_enough = 4 * std::numbers::pi * developable_limit;

enum class JointFate { united, keeps_edge, not_opposite, never, curved, not_flat, overlaps, same_piece };

struct JudgedStretch {
  JointStretch joint;
  std::string names[2];  // of the panels, as they were
  JointFate fate = JointFate::united;
  std::pair<int, int> kind{-1, -1};  // shapes of both pieces: pieces that are alike share their fate
  double distortion = 0;             // mean, laid flat as one piece
  double grain_turn = 0;             // radians, between the grain lines of both, when united
  std::set<int> vertices;            // of the garment before
};

// A note for each.
void describe_stretches(const std::vector<JudgedStretch>& stretches, const std::string& place, Report& report);

}  // namespace toile
