#pragma once
// The closed surface of the mannequin.

#include "body/parametric_net.h"

namespace toile {

struct Surface {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
};

// Moves the points of a net over the form until they are spaced evenly: `rounds` of tangential smoothing, each followed by a
// Newton step onto the form. Points on the midplane stay there.
void even_out(Net& net, const BodyForm& form, int rounds);

// Both halves, points of the midplane shared.
Surface mirrored_surface(const Net& net);

}  // namespace toile
