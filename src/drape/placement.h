#pragma once
// Where flat panels start before they are sewn: in front of, behind and around the body.

#include <Eigen/Core>
#include <vector>

#include "body/body.h"
#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// Start positions by panel (3 x panel vertices). A copy with a 3D placement is put where it says; one with a body part is
// rolled round that part of the body, grain upright, outside out, far enough from the body that the panels of one level and
// layer (layers.h) go round without overlapping, and outside those of the layers under it, `higher` m above its level. Throws
// BadInput("drape.no-placement") naming a piece that has neither.
std::vector<Eigen::Matrix3Xd> place_panels(const Pattern& pattern, const GarmentMesh& garment, const Body& body,
                                           double higher = 0);

}  // namespace toile
