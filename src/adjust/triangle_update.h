#pragma once
// The fixed point on one triangle: Eq. 6, 7 and 9 with their frames settled.

#include <Eigen/Core>

namespace toile {

// T^{k+1} = T B^gain with B = t^-1 t^g (Eq. 6-7). The goal is first turned onto the drape by the nearest rotation, which makes
// the step independent of the corner the triangles start from (Eq. 7 as printed turns shared edges onto each other, and is
// not), and the gain acts on the logarithm of what is left, a symmetric stretch. Returns `rest` when `draped` has collapsed.
Eigen::Matrix2d updated_rest(const Eigen::Matrix2d& rest, const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal,
                             double gain = 1);

// Eq. 9: `goal` stretched back where draping `rest` to `source` compressed it, along the principal axes of that compression.
Eigen::Matrix2d without_compression(const Eigen::Matrix2d& goal, const Eigen::Matrix2d& rest, const Eigen::Matrix2d& source);

}  // namespace toile
