#pragma once
// A loop that is moved along the body, what it is moved against, and what moves with it.

#include <optional>
#include <string>
#include <vector>

#include "body/relative.h"
#include "edit/edit_memory.h"
#include "edit/operation.h"
#include "edit/skeleton_chains.h"

namespace toile {

struct Handle {
  VertexLoop loop;
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();  // unit, the way the garment gets longer: from the anchor to the loop
  double level = 0;                                  // m, axis coordinate of the loop in the mean, or of the level it is at
  std::vector<VertexLoop> anchor;
  double anchor_level = 0;           // m, likewise of the anchor
  double room = 0;                   // m, along the axis between the nearest parts of loop and anchor
  std::optional<double> tight_edge;  // m, axis coordinate where the garment stops lying on the body all round
  std::vector<int> moving;           // vertices that reach the loop without passing the anchor, in order; the loop among them
};

// One per loop that `loop` names. `anchor` names the loop or level that stays, or is "auto": the nearest ring to the loop that
// lies on the body for at least half its length, but not so near that the fabric between would be stretched or squeezed beyond
// reason by a move of `by` metres. Throws BadInput: edit.anchor-elsewhere when no anchor bounds the part that moves, and what
// resolve_loops throws.
std::vector<Handle> make_handles(const EditInput& input, const std::string& loop, const std::string& anchor, double by,
                                 EditMemory& memory);

}  // namespace toile
