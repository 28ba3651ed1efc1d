#pragma once
// Crossings of welded cloth that are few and near each other, taken out where they are.

#include <Eigen/Core>
#include <vector>

#include "body/body.h"
#include "garment/mesh.h"

namespace toile {

// Spans the cloth round triangles that cross each other, and round the garment vertices `open`, smoothly (harmonic: every
// vertex in the middle of its neighbours, weighted by the lengths they are cut with) between what lies round it, `body_offset`
// (m) outside the body, and widens the patch ring by ring until nothing crosses; then lets all of it take its lengths again
// without passing through itself. `positions` (3 x garment vertices) stay as they are when that does not succeed, when much
// of the garment crosses, and when there is nothing to do; else true. Deterministic.
bool untangle(const GarmentMesh& garment, const Body& body, double body_offset, const std::vector<int>& open,
              Eigen::Matrix3Xd& positions);

}  // namespace toile
