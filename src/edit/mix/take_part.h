#pragma once
// The pattern of one side of a parted garment.

#include <vector>

#include "edit/mix/parting.h"

namespace toile {

struct Part {
  Pattern pattern;                           // pieces and seams of that side; new edges are called "mix", "mix_2", ...
  std::vector<std::vector<int>> panels;      // [piece][copy - 1]: the panel of the whole garment that it is part of
  std::vector<std::vector<EdgeSpan>> rings;  // by loop: what is open now, in order round
  std::vector<int> limbs;                    // by loop: what it is round, index into trunk_and_limbs
  std::vector<bool> across;                  // by loop: it runs across panels, not along their edges
};

// Throws BadInput edit.nothing-left when that side is empty.
Part take_part(const EditInput& input, const Parting& parting, bool beyond, const std::string& place);

}  // namespace toile
