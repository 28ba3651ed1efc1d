#pragma once
// A shorter or longer garment as its own cloth: cut off parallel to the loop, or carried on beyond it.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "edit/length/handle.h"

namespace toile {

// The drape with every loop slid along its own cloth, `by` metres along its axis in the mean and by the same length of cloth
// all round, as a pattern maker changes a hem. Seams slide along themselves, straight on beyond their ends, up to the anchor or
// to their other end if that is nearer; other edges stay, and the panels between follow smoothly. Shortened, the garment is
// part of the source surface, so normals, flare and the run of the seams stay exactly as they were; lengthened, it goes on as
// it hangs. The sides of a slit slide like seams: it ends where it ended. Nothing where that cannot be done: when the panels
// along the loop are not bounded by seams that run up from it, or hardly anything of them would be left.
std::optional<Eigen::Matrix3Xd> slid_on_cloth(const EditInput& input, const std::vector<Handle>& handles, double by);

}  // namespace toile
