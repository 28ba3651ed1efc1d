#pragma once
// One block of the file as a piece of the pattern.

#include <optional>

#include "formats/dxf_aama/drawn_piece.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile::aama {

// Outline counter-clockwise from the first turn point of the sew line in file order, edges "e0", "e1", ...; nothing, and an
// error, when the piece has no closed outline.
std::optional<Piece> make_piece(DrawnPiece drawn, Report& report);

}  // namespace toile::aama
