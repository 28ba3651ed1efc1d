#pragma once
// Triangles that a style solve turned over, laid anew.

#include <Eigen/Core>
#include <vector>

#include "style/hard_constraints.h"
#include "style/source_shape.h"

namespace toile {

// `x` with what lies round its turned triangles carried over from `source` instead: as the cloth about it moved, evened out,
// then solved for its style by itself. The patches grow until nothing in them is turned, up to eight rings of triangles; `x`
// itself when nothing is turned, or more than a fiftieth of the triangles. Vertices that `hard` names stay. `triangles`: the
// source's.
Eigen::Matrix3Xd mend_turned(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& source,
                             const Eigen::Matrix3Xd& x, const HardConstraints& hard);

}  // namespace toile
