#pragma once
// The best place for a joint within a region (paper Sec. 5, "Optimizing transition boundaries").

#include <vector>

#include "edit/mix/limb_curve.h"
#include "edit/operation.h"

namespace toile {

struct RegionCut {
  LimbCurve curve;      // where both garments are to be cut
  double length = 0;    // m, of the cut through the mesh, not yet smooth
  double turned = 0;    // radians, mean angle between the normals of both garments along it
  double shortest = 0;  // m, of the shortest cut there
};

// Between two loops of the first garment round one limb: the closed line of mesh edges of least sum of Eq. 10,
// tau |1 - n . n'| + |e| / height with tau = .4, n' at the same p_b and p_m of the second garment. Throws BadInput
// edit.bad-region when the loops are round different limbs or nothing is between them, edit.no-overlap when the second garment
// is not there.
RegionCut cut_in_region(const EditInput& first, const EditInput& second, const LimbCurve& from, const LimbCurve& to,
                        const std::string& place);

}  // namespace toile
