#pragma once
// The cut line where allowances run into each other.

#include <optional>
#include <vector>

#include "cut/offset.h"

namespace toile {

constexpr double same_place = 1e-7;  // m, points of a cut line this near are one

Polygon places(const Line& line);

// Index of the first edge that the cut line comes nearer to than the smallest of its allowance and those of the edges it meets;
// empty when there is none.
std::optional<std::size_t> first_too_near(const Line& cut, const std::vector<OffsetEdge>& edges);

// The outline of the net piece (polygon `net`) and all its allowances together, with the flags of the points of `raw` that are
// still there. Throws BadInput "cut.allowance-crosses" where they close a gap that is not a dart.
Line united_cut_line(const Piece& piece, const Polygon& net, const std::vector<OffsetEdge>& edges,
                     const std::vector<Joint>& joints, const Line& raw);

}  // namespace toile
