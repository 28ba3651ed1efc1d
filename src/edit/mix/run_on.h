#pragma once
// Edges that go on straight into each other made one edge: a side seam that two pieces brought along runs through.

#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// A corner of a piece: where edge `edge` of its outline starts.
struct PieceCorner {
  int piece = 0, edge = 0;
};

// At each of `corners` where the outline turns by less than 10 degrees and both edges are of a kind (hem, allowance, neither
// locked) they become one edge, named as the first; the bend is rounded over 4 cm. Spans of seams, notches and the panels'
// boundaries follow; two seams that then run on into each other become one. Vertices that are sewn together keep the same
// fractions of their spans.
void run_on(Pattern& pattern, GarmentMesh& garment, const std::vector<PieceCorner>& corners);

}  // namespace toile
