#pragma once
// Notches, drill holes, grain and internal lines of one piece.

#include <optional>

#include "formats/dxf_aama/drawn_piece.h"
#include "formats/svg_read/grouping.h"

namespace toile::svg {

// Sorts what is in `parts` beside its outlines (`sew`, `cut`) into `drawn`. Short lines that stand on an outline are notches;
// marks that stand on none are drill holes. `fold`: ends of the edge the piece is folded on.
void sort_details(const Drawing& drawing, const std::vector<Role>& roles, const PieceParts& parts, const Points<2>& sew,
                  const std::optional<Points<2>>& cut, const std::optional<std::pair<Eigen::Vector2d, Eigen::Vector2d>>& fold,
                  aama::DrawnPiece& drawn);

// Bends of a ring in full: where they are not known, by the angle between chords.
std::vector<bool> corners_of(const Ring& ring);

}  // namespace toile::svg
