#pragma once
// A smooth transition: near the joint the two garments are drawn together (paper Sec. 5, "Joining garment components").

#include <vector>

#include "edit/mix/joined.h"
#include "style/soft_terms.h"

namespace toile {

inline constexpr double blend_share = 0.01;  // tau of the body's height

// Draws vertices beside the joint to the middle between where they hang and the nearest place of the other garment, as the
// joint itself is held in the middle of both edges; square to the cloth only, along it everything follows the joint. Weighted
// by 1 - max(d, d')^2 / tau^2 with d, d' the distances of both places to the joint's edge of their garment. None where the
// other garment ends at the joint, has no cloth there or lies in another fold, and none where the mesh is coarser than tau.
// `positions`, `triangles`: both parts side by side, triangles in the order of the joined garment; `areas` by vertex, m^2.
std::vector<SoftTerm> alignment_terms(const Body& body, const JoinedGarment& joined, const Eigen::Matrix3Xd& positions,
                                      const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& areas, const EditInput& first,
                                      const EditInput& second);

}  // namespace toile
