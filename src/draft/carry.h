#pragma once
// What is marked inside a piece, carried along when the piece changes its shape.

#include <Eigen/Core>

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// Moves the internal lines, drill holes and grain line of `piece` as the triangles take them from `before` to `after` (both in
// the piece's frame); points off the mesh go with the nearest triangle. A grain line keeps its direction.
void carry_marks(Piece& piece, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& before,
                 const Eigen::Matrix2Xd& after);

}  // namespace toile
