#pragma once
// The seams of a garment as its welds tell them, and how well a rest shape keeps them.

#include <vector>

#include "garment/mesh.h"
#include "geometry/embed.h"

namespace toile {

// Every pair of boundary edges welded together, with the ratio of their lengths in the garment's own rest shape.
std::vector<MatingEdges> mating_edges(const GarmentMesh& garment);

// Panels with a seam whose two lengths differ by more than `tolerance` (a share), i.e. that are eased or gathered.
std::vector<bool> eased_panels(const GarmentMesh& garment, double tolerance = 1e-3);

// m, worst |length a - ratio * length b| over the pairs of pattern edges that are welded to each other, with the ratio they
// have in the garment's own rest shape.
double seam_mismatch(const GarmentMesh& garment, const RestShape& rest);

}  // namespace toile
