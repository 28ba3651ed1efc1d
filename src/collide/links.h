#pragma once
// Which limbs go through which openings. A garment can have closed seams and no intersections and still hang beside an arm.

#include <Eigen/Core>
#include <vector>

namespace toile {

// Signed crossings of the polyline `chain` with a surface that the closed `loop` bounds (the fan of triangles to its mean): how
// often the chain goes through the loop, positive where it comes from the side from which the loop runs clockwise. It depends
// on the two curves only, not on the surface, as long as both ends of the chain are far from the loop.
int crossings(const std::vector<Eigen::Vector3d>& loop, const std::vector<Eigen::Vector3d>& chain);

// [loop][chain] -> crossings.
Eigen::MatrixXi links(const std::vector<std::vector<Eigen::Vector3d>>& loops,
                      const std::vector<std::vector<Eigen::Vector3d>>& chains);

}  // namespace toile
