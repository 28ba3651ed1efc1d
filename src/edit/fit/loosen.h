#pragma once
// The whole garment farther from the body, or nearer to it.

#include <string>
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
// distance, or the garment could not hang. `name`: what stays and the release, for the memory.
Loosened loosen(const EditInput& input, double by, double release, const std::vector<VertexLoop>& stays, EditMemory& memory,
                const std::string& name);

}  // namespace toile
