#pragma once
// A piece of a cut sheet Toile wrote: every edge, notch and mark by its data attributes.

#include <optional>

#include "formats/svg_read/drawing.h"
#include "formats/svg_read/page.h"
#include "formats/svg_read/piece.h"

namespace toile::svg {

// `group` is its group; `bottom`: the page's height, m. Nothing when its sew lines are not drawn or do not close; then it is
// read like any other drawing.
std::optional<ReadPiece> own_piece(const Drawing& drawing, int group, double bottom);

}  // namespace toile::svg
