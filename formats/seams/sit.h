#pragma once
// Where the copies of a piece sit on the body: `on` and `place` of a [[piece]].

#include <string>

#include "formats/seams/values.h"

namespace toile {

// `on` is one table for all copies or a list with one table a copy:
//   part  = "trunk" | "arm.L" | "arm.R" | "leg.L" | "leg.R"  (default trunk)
//   level = a landmark of the body, drop = how far below it the top of the piece is
//   angle = round the part, 0 = centre front, 90 deg = the wearer's left; or
//   around = true: n copies share the full turn, copy k in the middle of its n-th, beginning at centre front, or at `first`
// One table for a piece cut as drawn and mirrored is mirrored too for the mirrored copies (other side, other angle).
// `place` is a list with one table a copy {shift = [x, y, z], turn = [about x, about y, about z]}: turned about the body's x,
// then y, then z axis, then shifted. Errors: "seams.bad-value", "seam.unknown-part", "seam.unknown-key", "seam.copies".
void sit_on_body(const TomlNode& entry, Piece& piece, Sidecar& sidecar);

// The same, written: lines "on = ..." and "place = ..." as far as something is known.
std::string sitting_text(const Piece& piece);

}  // namespace toile
