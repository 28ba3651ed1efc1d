#pragma once
// The shape of two parts that meet: each keeps its style, their edges coincide (paper Sec. 5, "Joining garment components").

#include "edit/mix/joined.h"
#include "edit/styled.h"

namespace toile {

struct MixedShape {
  Eigen::Matrix3Xd source;  // one column per garment vertex; at the joint the middle of both
  Eigen::Matrix3Xd positions;
  Styled styled;                     // of the two parts side by side
  double gap_mean = 0, gap_max = 0;  // m, between the edges before they were joined
};

// `first`, `second`: the whole garments.
MixedShape join_style(const Body& body, const JoinedGarment& joined, const EditInput& first, const EditInput& second);

}  // namespace toile
