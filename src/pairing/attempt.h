#pragma once
// A pattern taken for one kind of garment: what its names then mean, and the best seams for that.

#include <vector>

#include "garment/garment_template.h"
#include "pairing/assignment.h"
#include "pairing/names.h"
#include "pairing/panel_edges.h"

namespace toile {

struct Attempt {
  const GarmentTemplate* garment = nullptr;
  std::vector<PieceName> names;  // by piece
  std::vector<bool> sewn;        // by piece; false: lies on another one
  PanelEdges all;
  Problem problem;  // refers to `all` of its own attempt: see pose
  Assignment found;
};

std::vector<PieceName> names_of(const Pattern& pattern, const GarmentTemplate& garment);

// The problem of `attempt.all` as it is now.
void pose(Attempt& attempt);

// Edges sewn one to one, then longer ones shared out among several.
Attempt attempt_as(const Pattern& pattern, const GarmentTemplate& garment, int rounds);

}  // namespace toile
