#pragma once
// Where rays from inside a form leave it: rings and arcs of surface points, and chains of points spaced evenly.

#include <vector>

#include "body/parametric_form.h"

namespace toile {

using Chain = std::vector<Eigen::Vector3d>;

// The first way out of the form from `from` (inside it) along the unit `direction`, no further than `limit` m.
Eigen::Vector3d way_out(const BodyForm& form, const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double limit = .6);

// `count` rays in the plane through `centre` with normal `along`, the first towards `first`, turning from there towards
// along x first. A centre off the midplane keeps the ring on its side of it. No repeated end point.
Chain ring(const BodyForm& form, const Eigen::Vector3d& centre, const Eigen::Vector3d& first, const Eigen::Vector3d& along,
           int count);
// The same over half a turn, both ends included.
Chain half_ring(const BodyForm& form, const Eigen::Vector3d& centre, const Eigen::Vector3d& first, const Eigen::Vector3d& along,
                int count);

double length(const Chain& chain);
// The points at the given shares (ascending, 0 .. 1) of the open chain's length.
Chain at_shares(const Chain& chain, const std::vector<double>& shares);
// `count` >= 2 points spaced evenly over the open chain, both ends included.
Chain resampled(const Chain& chain, int count);
// `count` points spaced evenly over the closed chain, the first one kept.
Chain resampled_ring(Chain chain, int count);

}  // namespace toile
