#pragma once
// Slide, then freeze: the loop first gives way across its axis, so that a flare stays a flare; then it is held where it came to
// lie and the rest of the garment follows with the least change of style.

#include <vector>

#include "edit/edit_memory.h"
#include "edit/length/handle.h"
#include "style/normal_deviation.h"
#include "style/style_solve.h"

namespace toile {

struct SlideOptions {
  double by = 0;                  // m, positive = longer
  double release = 0.15;          // m from the loop over which the garment need not keep its distance to the body
  std::vector<VertexLoop> stays;  // loops that keep their place along the body (E_rl)
};

struct Slide {
  Eigen::Matrix3Xd positions;
  StyleTerms before, after;   // at the initial guess, at the end
  NormalDeviation deviation;  // of the triangles that moved
  double deepest = 0;         // m, how much deeper than in the source a vertex is inside the body
  bool settled = false;
  double in_plane_pull = 0;  // the beta that turned no triangle over
};

Slide slide_and_freeze(const EditInput& input, const std::vector<Handle>& handles, const SlideOptions& options,
                       EditMemory& memory);

}  // namespace toile
