#pragma once
// The whole garment farther from the body, or nearer to it.

#include <vector>

#include "edit/contact_region.h"
#include "edit/styled.h"

namespace toile {

struct Loosened {
  Styled styled;
  Eigen::VectorXd asked;  // m by vertex: `by`, less where the body stops it, on the shoulders and near what stays
  std::vector<int> moving;
};

// Every point `by` metres along the ray from its bone; `stays` (loops) and what is cut off by them do not move: the part that
// moves is the largest, all of it from `release` m off the loops on. Where cloth rests on skin that looks up it keeps its
// distance, or the garment could not hang.
Loosened loosen(const EditInput& input, const std::vector<RelativePlace>& places, const ContactRegion& contact, double by,
                double release, const std::vector<VertexLoop>& stays);

}  // namespace toile
