#pragma once
// Everything about a drape that people look at in colours.

#include <vector>

#include "body/body.h"
#include "garment/fabric.h"
#include "garment/garment_map.h"
#include "garment/mesh.h"

namespace toile {

// "stretch_warp", "stretch_weft", "stretch_bias" (by triangle, %, signed), "ease" (by vertex, mm), "pressure" (by vertex, kPa),
// in this order. `positions`: one column per garment vertex, m.
std::vector<GarmentMap> drape_maps(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body,
                                   const Fabric& fabric);

}  // namespace toile
