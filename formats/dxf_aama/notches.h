#pragma once
// Notches from where the file has them to their place on the sew line.

#include <optional>
#include <vector>

#include "formats/dxf_aama/drawn_piece.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile::aama {

// `outline` is the finished outline; `cut` the cut ring, when there is one. A notch goes to the nearest point of the sew line,
// or where its direction (group 50) meets it when that is about as near. A notch drawn on both lines is one notch; one that
// belongs to an internal line is left out (note "aama.notch-on-internal-line"); one off every line is moved (warning
// "aama.notch-off-outline"), beyond 60 mm left out.
std::vector<Notch> placed_notches(const DrawnPiece& piece, const std::vector<Edge>& outline,
                                  const std::optional<Points<2>>& cut, Report& report);

}  // namespace toile::aama
