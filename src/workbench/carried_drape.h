#pragma once
// A drape that came with its own triangles, on the triangles of its pattern.

#include <Eigen/Core>

#include "body/body.h"
#include "garment/mesh.h"
#include "garment/pattern_file.h"

namespace toile {

// Where the vertices of `garment` hang when its cloth hangs as `draped` does: every panel vertex lies on the triangle of the
// same copy of the same piece that it has in the flat (nearest where the outlines differ), a welded vertex in the mean of its
// panels'. Vertices inside the body are moved onto its surface, `offset` (m) off it, because flat triangles cut corners. Throws
// BadInput("drape.other-garment") when `draped` has no such panel.
Eigen::Matrix3Xd carried_drape(const DrapedGarment& draped, const GarmentMesh& garment, const Body& body, double offset = 1e-3);

}  // namespace toile
