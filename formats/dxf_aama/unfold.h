#pragma once
// Half pieces drawn up to a mirror line (layer 6), made whole.

#include <Eigen/Core>
#include <optional>

#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/drawn_piece.h"

namespace toile::aama {

struct Axis {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();  // unit
};

// The longest line of layer 6; nothing when there is none with a length.
std::optional<Axis> mirror_axis(const DrawnPiece& piece);

Eigen::Vector2d reflected(const Eigen::Vector2d& at, const Axis& axis);
double distance_to_axis(const Eigen::Vector2d& at, const Axis& axis);  // m

// The whole ring of a half: of a closed chain with an edge on the axis, or of an open one with both ends there (within
// closing_gap; they are put on it exactly). It begins where the file's half begins and runs in the file's direction. Nothing
// when the chain is not a half.
std::optional<Points<2>> unfolded(const Chain& half, const Axis& axis);

// Points, notches, drill holes and internal lines of the half and their reflections; what lies on the axis once, internal lines
// labelled NM as drawn. The outlines are left alone.
void unfold_details(DrawnPiece& piece, const Axis& axis);

}  // namespace toile::aama
