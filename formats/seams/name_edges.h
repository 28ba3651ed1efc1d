#pragma once
// Gives the edges of a piece the names a pattern maker uses.

#include "formats/seams/values.h"

namespace toile {

// Reads `edges` and `start` of a [[piece]] and names the outline's edges, counter-clockwise from the start corner (default:
// where the outline begins). An empty name leaves the edge its number. The same name for neighbours joins them into one edge;
// the turn point between them becomes a curve point. Notches move with their edges. Errors: "seam.edge-count" listing the edges
// there are, "seam.edge-name", "seam.start".
void name_edges(const TomlNode& entry, Piece& piece, Sidecar& sidecar);

// Index of the edge that starts at the corner that "bottom left", "top right", ... names; nothing when it names none.
// Left, right, top and bottom are those of the piece as it is drawn.
std::optional<std::size_t> corner_in_words(const Piece& piece, const std::string& words);

}  // namespace toile
