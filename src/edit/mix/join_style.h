#pragma once
// The shape of two parts that meet: each keeps its style, their edges coincide (paper Sec. 5, "Joining garment components").

#include "edit/mix/joined.h"
#include "edit/styled.h"

namespace toile {

// The two parts not yet joined: vertices of the joint twice, the second side's after all others.
struct SideBySide {
  Eigen::Matrix3Xd positions;  // 3 x vertices, as they hang
  Eigen::Matrix3Xi triangles;  // in the order of the joined garment
  std::vector<int> welded;     // [vertex] -> garment vertex
};

SideBySide side_by_side(const JoinedGarment& joined);

struct MixedShape {
  Eigen::Matrix3Xd source;  // one column per garment vertex; at the joint the middle of both
  Eigen::Matrix3Xd positions;
  Styled styled;                     // of the two parts side by side
  double gap_mean = 0, gap_max = 0;  // m, between the edges before they were joined
};

// `first`, `second`: the whole garments.
MixedShape join_style(const Body& body, const JoinedGarment& joined, const EditInput& first, const EditInput& second);

}  // namespace toile
