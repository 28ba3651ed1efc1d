#pragma once
// Where the boundary of a panel lies on the outline of its piece, and panels laid on the frame of their piece.

#include <vector>

#include "garment/mesh.h"

namespace toile {

// [panel][i]: fraction of its edge at which boundary[i] lies when the panels are shaped like `like`. A vertex moves along its
// edge as far as the stretch against the garment's own rest shape is uneven; corners, and the ends of what is sewn to one other
// edge, stay. What is sewn together moves by the same share (the mean of both sides). Equals boundary[i].at where nothing is
// stretched.
std::vector<std::vector<double>> places_on_outline(const GarmentMesh& garment, const RestShape& like);

// The panel in its piece's frame: a mirrored copy reflected back.
Eigen::Matrix2Xd as_drawn(const PanelMesh& panel, Eigen::Matrix2Xd at);

// `at` turned so that its mean rotation against `reference` (weighted by area) is zero, and shifted so that both have their
// centroid in one place. Triangles of `reference` are counter-clockwise or all clockwise.
Eigen::Matrix2Xd laid_on(const Eigen::Matrix2Xd& reference, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& at);

}  // namespace toile
