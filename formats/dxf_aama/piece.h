#pragma once
// One block of the file as a piece of the pattern.

#include <optional>

#include "formats/dxf_aama/drawn_piece.h"
#include "formats/dxf_aama/unfold.h"
#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile::aama {

struct MadePiece {
  Piece piece;
  PieceFacts facts;
  std::optional<Axis> fold;  // it was unfolded over this
};

// Outline counter-clockwise from the first turn point of the sew line in file order, edges "e0", "e1", ...; nothing, and an
// error, when the piece has no closed outline.
std::optional<MadePiece> make_piece(DrawnPiece drawn, Report& report);

}  // namespace toile::aama
