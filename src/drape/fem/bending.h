#pragma once
// Quadratic bending over the edges of the welded garment (Bergou et al. 2006): constant Hessian, exact for isometric motion.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "garment/fabric.h"
#include "garment/mesh.h"

namespace toile::fem {

// Energy 1/2 * stiffness * |sum_i weight[i] x_i|^2. Vertices: both ends of the edge, then the corners off it.
struct Hinge {
  std::array<int, 4> vertex{};
  std::array<double, 4> weight{};
  double stiffness = 0;  // N m / m^2
};

// One hinge per inner edge (stiffness grows with the third power of the layers there, as of one thicker cloth) and per seam
// edge; across a seam each side uses its own rest triangle.
std::vector<Hinge> bending_hinges(const GarmentMesh& garment, const Fabric& fabric);

Eigen::Vector3d hinge_vector(const Hinge& hinge, const Eigen::Matrix3Xd& x);

}  // namespace toile::fem
