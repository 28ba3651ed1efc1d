#pragma once
// What must hold of a piece's outline before it can be meshed.

#include <Eigen/Core>
#include <vector>

#include "garment/pattern.h"

namespace toile {

// The piece's outline as a polygon without equal points in a row, with the edge each side belongs to.
struct OutlinePolygon {
  std::vector<Eigen::Vector2d> corners;
  std::vector<int> edge;  // of the side that starts at the corner
};
OutlinePolygon outline_polygon(const Piece& piece);

// Throws BadInput for the first piece whose outline is not a simple, closed, counter-clockwise loop of finite points:
// "pattern.no-outline", "pattern.not-finite", "pattern.edge-without-length", "pattern.open-outline", "pattern.self-crossing",
// "pattern.clockwise-outline".
void check_outlines(const Pattern& pattern);

}  // namespace toile
