#pragma once
// Which vertices of an outline are corners.

#include <optional>
#include <vector>

#include "formats/dxf_aama/drawn_piece.h"
#include "formats/dxf_aama/unfold.h"

namespace toile::aama {

// Vertices of a ring (no repeated point) where the line turns by more than `angle` radians at once: what is left of the turn
// when both sides are continued as the circles through their last vertices, so that the vertices of a sampled curve are none.
// Vertices nearer together than 0.5 mm count as one.
std::vector<bool> corners_by_angle(const Points<2>& ring, double angle);

struct TurnPoints {
  std::vector<bool> turn;  // by vertex; at least one is true
  bool by_angle = false;   // the file marks no turn point of this ring
};

// From the file's layers 2 and 3 (what is listed first holds, unlisted vertices are curve points), by angle when the file marks
// no turn point of this ring. Where a half was unfolded, the vertices on the axis are turn points only when there is a corner.
TurnPoints turn_points(const Points<2>& ring, const DrawnPiece& piece, const std::optional<Axis>& fold);

}  // namespace toile::aama
