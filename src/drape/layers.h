#pragma once
// Which panels of a garment lie over which, where several pieces are sewn into one seam.

#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// By panel: how many layers lie between it and the body, 0 for all panels of a garment that has one layer. Of panels that hang
// from the same side of a seam, that with the lower Piece::layer lies inside; where neither says, that which its 3D placement
// puts farther in; else that whose seam is written first. Panels sewn to each other otherwise are of one layer, with what is
// on the other side of a seam the innermost of both sides, the next of both, and so on.
std::vector<int> panel_layers(const Pattern& pattern, const GarmentMesh& garment);

}  // namespace toile
