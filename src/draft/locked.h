#pragma once
// Edges that the user wants left as they are: congruent to how they were drawn.

#include <vector>

#include "draft/runs.h"
#include "garment/pattern.h"

namespace toile {

// Two places on an edge that stay as far apart as they were. Where its curve keeps its shape too, all of the edge does.
struct KeptDistance {
  int piece = 0, edge = 0;
  double from = 0, to = 1;  // fractions of the edge
  double distance = 0;      // m
};

// Of every locked edge: its ends, or where it is several curves all of their ends, so many that they form a rigid figure.
std::vector<KeptDistance> kept_distances(const Pattern& pattern);

// Whether run `run` of `piece` is of a locked edge and must not be bent.
bool is_locked(const Piece& piece, const Run& run);

}  // namespace toile
