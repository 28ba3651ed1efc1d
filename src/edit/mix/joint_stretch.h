#pragma once
// A joint stretch by stretch: which pieces meet there, and how far from flat the garment is along it (paper Sec. 5, "Joining
// garment components": patterns are joined where the Gaussian curvature along the transition is small).

#include <optional>
#include <set>
#include <vector>

#include "edit/mix/united_piece.h"
#include "garment/mesh.h"

namespace toile {

struct JointStretch {
  int seam = 0;            // index into the pattern's seams
  double length = 0;       // m
  double curvature = 0;    // radians: sum of the angle defects along it, positive where the garment bulges
  double turns_apart = 0;  // radians: the greatest sum, by amount, over any part of it
};

// Of the vertices of the two panels within `reach` (m) of the seam and their neighbours, at the nearest place on it: blending
// spreads the curvature of a joint so far. `positions`: one column per garment vertex. What lies on the panels' other edges is
// left out: it is the other seams' business.
JointStretch joint_stretch(const Pattern& pattern, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, int seam,
                           double reach);

// Garment vertices of the seam, ends included.
std::set<int> vertices_of_seam(const Pattern& pattern, const GarmentMesh& garment, int seam);

// The two pieces that the seam joins edge to edge, whole edges of two different pieces, with this pair of copies alone; the
// larger one is the base.
std::optional<PieceJoin> whole_edges(const Pattern& pattern, int seam);

}  // namespace toile
