#pragma once
// Moves along the body that cannot be made.

#include <string>
#include <vector>

#include "edit/length/handle.h"

namespace toile {

// Throws BadInput, with the most that is possible:
//  edit.slips-off    more than half of the area the garment hangs by would be gone
//  edit.past-anchor  the loop would pass its anchor, or squeeze what lies between to less than a quarter
//  edit.below-floor  the loop would go below the floor
// `areas` by vertex, m^2; `by` in metres, positive = longer.
void refuse_impossible(const EditInput& input, const std::vector<Handle>& handles, const ContactRegion& contact,
                       const Eigen::VectorXd& areas, double by);

}  // namespace toile
