#pragma once
// Darts of a piece: V cuts in its outline, and V and diamond lines inside it.

#include "garment/pattern.h"
#include "garment/report.h"

namespace toile::svg {

// Names the legs of each V in the outline "dart1a", "dart1b", ... (notches move with them) and reports them, and lines inside
// that are drawn as darts: "svg.darts".
void name_darts(Piece& piece, const std::string& place, Report& report);

}  // namespace toile::svg
