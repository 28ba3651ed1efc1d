#pragma once
// The boundaries of a garment's panels, piece by piece of mesh edge, and what each is welded to.

#include <vector>

#include "garment/mesh.h"

namespace toile {

// One mesh edge of a panel's boundary, with the panel on its left.
struct BoundarySegment {
  int panel = 0;
  int from = 0, to = 0;       // panel vertices
  int edge = 0;               // index into Piece::outline
  double begin = 0, end = 1;  // fractions of that edge at `from` and `to`; begin > end on mirrored copies
  std::vector<int> mates;     // the segments welded to it, by their place in the list
  bool operator==(const BoundarySegment&) const = default;
};

// Panels in order, each in the order of its `boundary`.
std::vector<BoundarySegment> boundary_segments(const GarmentMesh&);

}  // namespace toile
