#pragma once
// What is sewn to what: a [[seam]] of the sidecar as seams of the pattern.

#include "formats/seams/values.h"

namespace toile {

// Appends the seams that `entry` describes. Three forms:
//   a, b         two runs of edges
//   ring         a piece whose copies are sewn in a circle, edge `from` of each to edge `to` of the next (`open`: last not to
//   first) along, each  one long run shared out among other edges in the order given, in proportion to their lengths, from
//   `start` on
// Edges are joined right side to right side as their outlines run against each other, i.e. the beginning of one meets the end
// of the other; `reversed` joins beginning to beginning. `right_to_wrong` lays the right side on the wrong side. `ease` is how
// much longer the longer one may be; more is a warning "seam.length". Errors: "seam.syntax", "seam.unknown-piece",
// "seam.unknown-copy", "seam.unknown-edge", "seam.range", "seam.unknown-key".
void add_seams(const TomlNode& entry, Pattern& pattern, Sidecar& sidecar);

}  // namespace toile
