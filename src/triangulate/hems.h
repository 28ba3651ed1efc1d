#pragma once
// Hems as they are worn: turned up, so that the cloth lies double along the edge.

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// `garment` with `layers` set from its present rest shapes: 2 within the allowance of an edge that its piece marks as a hem
// (`depth`, in m, where the edge has none of its own), falling to 1 over the width of a triangle.
GarmentMesh with_hems(const Pattern& pattern, GarmentMesh garment, double depth);

}  // namespace toile
