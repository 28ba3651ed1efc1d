#pragma once
// Where an edit leaves off when nobody says so: at the edge of the part that lies on the body.

#include <optional>
#include <vector>

#include "edit/contact_region.h"
#include "edit/edit_memory.h"
#include "edit/level_loops.h"
#include "edit/operation.h"

namespace toile {

struct AutomaticAnchor {
  VertexLoop ring;                   // empty: there is no ring between the loop and the end of its limb
  double level = 0;                  // m, axis coordinate of the plane it is at; none of its vertices is beyond it
  std::optional<double> tight_edge;  // m, axis coordinate nearest to the loop where at least half of a ring lies on the body
};

// Looks from `loop` (at axis coordinate `level`) against `axis`, ring by ring round the same limb (or the trunk, for a leg),
// over the vertices that are `connected` to it. A move of `by` metres wants 1.8 times as much room to shorten, 1.5 times to
// lengthen; the ring is the nearest one at or beyond the tight edge with that room, or the farthest there is.
AutomaticAnchor automatic_anchor(const EditInput& input, const LevelMesh& mesh, const ContactRegion& contact,
                                 const VertexLoop& loop, const Eigen::Vector3d& axis, double level,
                                 const std::vector<bool>& connected, double by, EditMemory& memory);

}  // namespace toile
