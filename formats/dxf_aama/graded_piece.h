#pragma once
// A finished piece in its other sizes.

#include <optional>
#include <vector>

#include "formats/dxf_aama/graded_lines.h"
#include "formats/dxf_aama/unfold.h"
#include "garment/pattern.h"

namespace toile::aama {

// The piece in each of `sizes` sizes, with the same edges, points and marks. What lies on a line moves as the line does there,
// on the other side of `fold` mirrored in the fold of that size; what lies on none (drill holes, a grain line that is not
// graded) keeps its place relative to the outline (mean value coordinates, Floater 2003). Notches stay between the same outline
// points, unless they have moves of their own. Without graded lines every size is the piece itself.
std::vector<Piece> graded_pieces(const Piece& piece, const std::optional<Axis>& fold, const GradedLines& graded,
                                 std::size_t sizes);

}  // namespace toile::aama
