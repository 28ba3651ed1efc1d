#pragma once
// How far the cloth of a drape is pulled, thread by thread.

#include <Eigen/Core>

#include "garment/mesh.h"

namespace toile {

// By garment triangle: length of a line of the cloth / its length at rest - 1, so 0.03 is 3 % longer, negative is pushed
// together. Directions are those of the panel's own grain.
struct GrainStretch {
  Eigen::VectorXd warp, weft;
  Eigen::VectorXd bias;  // at 45 degrees to the grain, the one of both diagonals that is longer now
};

// `positions`: one column per garment vertex, m. Throws std::invalid_argument for another number.
GrainStretch grain_stretch(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions);

}  // namespace toile
