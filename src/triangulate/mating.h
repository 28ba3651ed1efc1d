#pragma once
// Which edges of a garment's panels are sewn to each other.

#include <vector>

#include "garment/mesh.h"
#include "garment/pattern.h"
#include "geometry/embed.h"

namespace toile {

// Pairs of panel boundary edges joined by the pattern's seams, in order of seams and from each seam's start; vertices are the
// panels' own. `ratio` is that of the chords between their places on the pattern's outlines, whatever rest shape `garment` has,
// so that ease stays as it was drawn.
std::vector<MatingEdges> mating_edges(const Pattern& pattern, const GarmentMesh& garment);

}  // namespace toile
