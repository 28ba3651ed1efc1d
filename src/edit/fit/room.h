#pragma once
// How far the points of a loop may go towards the body.

#include <Eigen/Core>

#include "body/body.h"
#include "edit/skeleton_chains.h"

namespace toile {

// m by loop vertex, against `outward` (unit, by loop vertex, from the bone, `reach` m away), until it is `least` (m by garment
// vertex) off the skin, or at that distance from the taut tape round the parts of the body inside the loop when there are
// several; three quarters of the way to the bone at most. `axis`: unit, along the limb.
Eigen::VectorXd room_inwards(const Body& body, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                             const Eigen::Vector3d& axis, const Eigen::Matrix3Xd& outward, const Eigen::VectorXd& reach,
                             const Eigen::VectorXd& least);

}  // namespace toile
