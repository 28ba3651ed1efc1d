#pragma once
// How far the cut line lies outside the sew line.

#include <optional>
#include <vector>

#include "geometry/polyline.h"

namespace toile::aama {

struct Allowance {
  std::optional<double> width;  // m, median along the edge, rounded to 0.01 mm; nothing: no cut line within 100 mm
  double spread = 0;            // m, between the narrowest and the widest of the middle three quarters of the samples
  bool faces_itself = false;    // a dart's leg: outwards of it lies the piece itself, before any cut line; no width then
};

// Measured square to `edge` (a run of the counter-clockwise ring `sew`) to the cut ring, away from the edge's ends.
Allowance measured_allowance(const Points<2>& edge, const Points<2>& sew, const Points<2>& cut);

}  // namespace toile::aama
