#pragma once
// A drape on one mesh of a pattern, as the start of one on a finer mesh.

#include <Eigen/Core>

#include "garment/mesh.h"

namespace toile {

// Where the vertices of `fine` lie on `drape` (3 x vertices of `coarse`), by their place in the rest shapes; where panels meet,
// in the mean. Both are meshes of one pattern: the same panels in the same frames. Throws std::invalid_argument when they have
// different numbers of panels.
Eigen::Matrix3Xd carried_over(const GarmentMesh& coarse, const Eigen::Matrix3Xd& drape, const GarmentMesh& fine);

}  // namespace toile
