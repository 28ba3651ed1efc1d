#pragma once
// The left and the right of a garment.

#include <vector>

#include "pairing/names.h"
#include "pairing/panel_edges.h"

namespace toile {

// By edge: its mirror image on the other half of the garment (itself for an edge across the middle); -1: none is known. An
// involution. Panels are images of each other when their outlines agree after a reflection; `names` (by piece) settle which,
// where several do.
std::vector<int> mirror_images(const PanelEdges& all, const std::vector<PieceName>& names);

// Whether two panels have the same outline, not mirrored; the edge of `b` that lies on the first edge of `a`, or -1.
int same_outline(const PanelEdges& all, int a, int b);

}  // namespace toile
