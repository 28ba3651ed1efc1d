#pragma once
// Whether edges that are sewn together fit: their lengths, and notch to notch.

#include <map>
#include <string>
#include <vector>

#include "garment/pattern.h"

namespace toile {

struct NotchCheck {
  double on_a = 0, on_b = 0;  // m from the seam's start
};

struct SeamCheck {
  std::string seam;  // name, or what is sewn to what
  EdgeSpan a, b;
  double length_a = 0, length_b = 0;  // m
  double ease = 0;                    // m, meant
  double mismatch = 0;                // m, difference of the lengths beyond the ease
  std::vector<NotchCheck> notches;    // that belong together
  double notch_mismatch = 0;          // m, the worst of these beyond what the difference of lengths explains
  int lonely_notches = 0;             // without a partner on the other edge
};

// One per seam of the pattern, in order. `ease` is by the seam's name: what its sidecar says is meant.
std::vector<SeamCheck> check_seams(const Pattern& pattern, const std::map<std::string, double>& ease = {});

}  // namespace toile
