#pragma once
// Crossings of welded cloth that are few and near each other, taken out where they are.

#include <Eigen/Core>

#include "body/body.h"
#include "garment/mesh.h"

namespace toile {

// Spans the cloth round triangles that cross each other smoothly (harmonic: every vertex in the middle of its neighbours,
// weighted by the lengths they are cut with) between what lies round it, `body_offset` (m) outside the body, and widens the
// patch ring by ring until nothing crosses; then lets all of it take its lengths again without passing through itself.
// `positions` (3 x garment vertices) stay as they are when that does not succeed, or when much of the garment crosses.
// Returns the pairs of triangles that still cross. Deterministic.
int untangle(const GarmentMesh& garment, const Body& body, double body_offset, Eigen::Matrix3Xd& positions);

}  // namespace toile
