#pragma once
// The triangles of the mannequin, laid out once on a reference body and then on every other: rows of points round trunk, neck,
// arm and leg, the same rows with the same number of points in every size, so that point i of one size is point i of the next.

#include <array>
#include <vector>

#include "body/parametric_rays.h"

namespace toile {

// The wearer's left half (x >= 0), open along the midplane.
struct Net {
  Chain points;
  std::vector<std::array<int, 3>> triangles;  // outwards
  std::vector<int> counts;                    // of points and rows in the order they were decided
};

// Lays out rows about `edge_length` m apart and connects them.
Net lay_out_net(const BodyForm& form, const Figure& figure, double edge_length);
// The points of `reference` on another body.
Chain laid_out_like(const Net& reference, const BodyForm& form, const Figure& figure);

}  // namespace toile
