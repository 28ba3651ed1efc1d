#pragma once
// The air between a garment and the body.

#include <Eigen/Core>

#include "body/body.h"

namespace toile {

// m, distance of each point from the body's surface, negative inside: as the simulators see it within the band of the body's
// distance field, to the nearest triangle of the skin beyond.
Eigen::VectorXd air_to_body(const Eigen::Matrix3Xd& positions, const Body& body);

}  // namespace toile
