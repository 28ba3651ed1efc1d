#pragma once
// A shorter garment as part of the longer one.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "edit/length/handle.h"

namespace toile {

// The drape with every loop slid back by -`by` (m, by < 0) along its axis on the source surface itself: seams slide along
// themselves, the panels between follow smoothly, so normals, flare and the run of the seams stay exactly as they were. Nothing
// where that cannot be done: when the garment gets longer, or when a panel between anchor and loop is not bounded by seams that
// run from the one to the other.
std::optional<Eigen::Matrix3Xd> trimmed(const EditInput& input, const std::vector<Handle>& handles, double by);

}  // namespace toile
