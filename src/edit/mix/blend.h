#pragma once
// A smooth transition: near the joint cloth takes on the style of both garments (paper Sec. 5, "Joining garment components").

#include <vector>

#include "edit/mix/joined.h"
#include "style/source_shape.h"

namespace toile {

inline constexpr double blend_share = 0.01;  // tau of the body's height

// The cloth of the other garment nearest to every triangle beside the joint, as further source triangles over the
// same vertices. Their area is weighted by 1 - max(d, d')^2 / tau^2 with tau = blend_share and d, d' the distances
// to the joint's edge of either garment: the paper's weight of aligning v and v', taken here as one vertex. None where the
// other garment ends at the joint, has no cloth there or lies in another fold. `positions`, `triangles`: both parts side by
// side, triangles in the order of the joined garment.
std::vector<SourceTriangle> blended_style(const Body& body, const JoinedGarment& joined, const Eigen::Matrix3Xd& positions,
                                          const Eigen::Matrix3Xi& triangles, const EditInput& first, const EditInput& second);

}  // namespace toile
