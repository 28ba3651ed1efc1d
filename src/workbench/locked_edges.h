#pragma once
// Edges that a recipe wants left as they are.

#include <string>
#include <vector>

#include "garment/pattern.h"

namespace toile {

// Marks the edges named, "neck" (of every piece that has one) or "FRONT.neck". Throws BadInput("adjust.unknown-edge") listing
// what there is; `place` is for the message.
void lock_edges(Pattern& pattern, const std::vector<std::string>& names, const std::string& place);

}  // namespace toile
