#pragma once
// How far the cut line lies outside the sew line.

#include <optional>
#include <vector>

#include "geometry/polyline.h"

namespace toile::aama {

struct Allowance {
  double width = 0;   // m, median along the edge, rounded to 0.01 mm
  double spread = 0;  // m, between the narrowest and the widest of the middle three quarters of the samples
};

// Measured square to `edge` (a run of a counter-clockwise sew line) to the cut ring, away from the edge's ends; nothing when
// the cut line is not met within 100 mm.
std::optional<Allowance> measured_allowance(const Points<2>& edge, const Points<2>& cut);

}  // namespace toile::aama
