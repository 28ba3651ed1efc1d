#pragma once
// Where a draped garment is pulled further than its cloth gives: it is too small there.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/fabric.h"
#include "garment/mannequin.h"
#include "garment/mesh.h"
#include "garment/report.h"

namespace toile {

struct PanelStretch {
  double strain = 0;  // along the thread: exceeded on just `least_area` of the panel, so that one odd triangle does not count
  double height = 0;  // m above the floor, of the middle of what is stretched as much
};

constexpr double least_area = 5e-4;  // m^2

// By panel, of `garment` hanging at `positions` (one column per garment vertex). Strains are taken along warp and weft, where
// cloth does not give; across them it shears.
std::vector<PanelStretch> panel_stretches(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions);

// A warning "drape.overstretched" naming the panel that is stretched most, by how much, at what height, and the other panels
// beyond the fabric's most_stretch; nothing when there is none. `what` names the drape.
Report stretch_findings(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Fabric& fabric,
                        const Mannequin& form, const std::string& what);

}  // namespace toile
