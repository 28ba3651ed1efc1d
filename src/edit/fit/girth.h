#pragma once
// The offset that makes a loop longer by what is asked.

#include "edit/fit/fit_loop.h"

namespace toile {

// m, the one offset of all points in the range with which the loop measures `girth` m more along the cloth (minus: less). Where
// the body stops it before, the farthest it can go, with a warning edit.stopped-at-body in `report`. Throws
// BadInput("edit.out-of-range") when half a metre is not enough.
double offset_for_girth(const FitLoop& fit, const Eigen::Matrix3Xd& positions, double girth, Report& report);

}  // namespace toile
