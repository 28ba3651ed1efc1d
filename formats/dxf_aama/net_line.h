#pragma once
// The net (sew) line of a piece, wherever the file has put it, and the cut line.

#include <optional>
#include <string>

#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/drawn_piece.h"
#include "formats/dxf_aama/unfold.h"
#include "garment/report.h"

namespace toile::aama {

struct NetLine {
  Points<2> sew;                 // in file order and direction, no repeated point
  std::optional<Points<2>> cut;  // absent: the file has one line only, taken as net
  std::optional<Axis> fold;      // the piece is drawn as a half; both lines are whole, its details are not yet
  std::string source;            // PieceFacts::sew_line_source
};

// Layer 14 where it closes (by itself, over the mirror line, or along the cut line where there is no allowance); else the
// closed line on layer 8 that runs inside the boundary at 3 .. 50 mm, the same all along each edge (darts aside); else the
// boundary itself, with the warning "aama.no-sew-line". The line found on layer 8 is taken out of the piece's internal lines.
// Layers 84 and 87 replace 1 and 14 where they draw the same line more densely. The lines of a half are unfolded.
// Error "aama.open-outline".
std::optional<NetLine> net_line(DrawnPiece& piece, Report& report);

}  // namespace toile::aama
