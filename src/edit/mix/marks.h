#pragma once
// What a piece carries beside its outline, on a part of it.

#include <string>
#include <vector>

#include "garment/pattern.h"

namespace toile {

// `whole` with another outline, inside or along its own: name, material, the copies that are left (ascending), grain line,
// lines and holes that are on it. Without notches.
Piece marked_like(const Piece& whole, std::vector<Edge> outline, const std::vector<int>& copies);

// Adds the notches of edge `edge` of `whole` between `begin` and `end` of it, which is edge `id` of `piece` now.
void keep_notches(Piece& piece, const Piece& whole, int edge, const std::string& id, double begin, double end);

}  // namespace toile
