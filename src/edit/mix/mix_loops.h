#pragma once
// Where two garments are cut so that a part of one meets a part of the other.

#include <string>
#include <vector>

#include "edit/mix/cut_line.h"
#include "edit/operation.h"

namespace toile {

struct MixLoops {
  std::vector<CutLoop> first, second;  // as many, in pairs
  Report report;
};

// `loop` names loops of the first garment. "auto" as `other_loop` takes the second garment's edges of that name when they
// hang near, else its lines with the same p_b and
// p_m (paper Sec. 5), or its seam or free edge when that is near; else it names loops round the same limbs. Throws BadInput:
// edit.no-overlap when the second garment has nothing near there, edit.other-loops when the loops do not pair up.
MixLoops mix_loops(const EditInput& first, const EditInput& second, const std::string& loop, const std::string& other_loop);

// `region` names two loops of the first garment, "waist..hip"; both garments are cut at the best place between them.
MixLoops mix_loops_in(const EditInput& first, const EditInput& second, const std::string& region);

}  // namespace toile
