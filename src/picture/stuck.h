#pragma once
// What did not come together in sewing, and where.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/mannequin.h"
#include "garment/mesh.h"
#include "picture/image.h"

namespace toile {

// Panels before their seams are welded.
struct LooseGarment {
  GarmentMesh mesh;            // with every panel's vertices its own, panel after panel
  Eigen::Matrix3Xd positions;  // m
};

// `panels`: positions by panel of `garment`. Throws std::invalid_argument for a wrong number.
LooseGarment loose_garment(const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& panels);

// Front, side and back of the loose panels beside the whole body, and once more close to the worst place where there is one.
// Red is where it stuck: `where` of the welded `garment`'s vertices, with a line across every stitch that is open there.
Image stuck_picture(const Mannequin& body, const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& panels,
                    const std::vector<int>& where, const std::string& title, int samples = 3);

}  // namespace toile
