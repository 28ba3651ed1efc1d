#pragma once
// Notches from where the file has them to their place on the sew line.

#include <optional>
#include <vector>

#include "formats/dxf_aama/drawn_piece.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile::aama {

// Takes out notches that are on an internal line and on no outline (notes "aama.notch-on-internal-line"); Toile's lines have
// none.
void drop_notches_on_internal_lines(DrawnPiece& piece, const Points<2>& sew, const std::optional<Points<2>>& cut,
                                    Report& report);

// `outline` is the finished outline; `cut` the cut ring, when there is one. A notch goes to the nearest point of the sew line,
// or where its direction (group 50) meets it when that is about as near. A notch drawn on both lines is one notch; one off both
// is moved (warning "aama.notch-off-outline"), beyond 60 mm left out.
std::vector<Notch> placed_notches(const DrawnPiece& piece, const std::vector<Edge>& outline,
                                  const std::optional<Points<2>>& cut, Report& report);

}  // namespace toile::aama
