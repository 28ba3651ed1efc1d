#pragma once
// Loops that a garment has by the way it is worn, whatever its edges are called.

#include <vector>

#include "edit/operation.h"
#include "edit/skeleton_chains.h"

namespace toile {

// Where sleeves begin, one loop for each arm, the wearer's left first: the seam between the panels that lie round the arm and
// the others, or without such panels the free edge round the arm no more than 12 cm beyond the shoulder joint. None for an arm
// that has neither, such as a sleeve cut in one with the bodice, and for a body whose arms are not known.
struct Armhole {
  bool left = false;
  VertexLoop loop;
};
std::vector<Armhole> armholes(const EditInput& input);

// Round the neck, at most one: the seam below collar and stand, or without them the free edge.
std::vector<VertexLoop> necklines(const EditInput& input);

}  // namespace toile
