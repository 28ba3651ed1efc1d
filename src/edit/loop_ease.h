#pragma once
// Girth of a garment along one of its loops, and of the body inside it.

#include <Eigen/Core>

#include "edit/skeleton_chains.h"
#include "garment/mannequin.h"

namespace toile {

struct LoopEase {
  double along = 0;  // m, along the cloth of the loop, folds included
  double tape = 0;   // m, taut tape round it, across `axis`
  double body = 0;   // m, taut tape round what of the body is inside the loop there; 0: nothing is
  double ease() const { return tape - body; }
};

// In the plane through the loop's middle, square to `axis` (unit). Both legs inside a loop are taped together.
LoopEase loop_ease(const Mannequin& form, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                   const Eigen::Vector3d& axis);

}  // namespace toile
