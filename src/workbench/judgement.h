#pragma once
// Whether the adjusted pattern does what was asked, and where it does not (unrealisable targets, design notes on the paper's
// Sec. 8).

#include <string>

#include "measure/tailoring.h"
#include "workbench/workbench.h"

namespace toile {

// Somewhere on a garment, in words: "piece 'FRONT', 1032 mm above the floor, at the front".
std::string place_of(const GarmentMesh& garment, int panel, const Eigen::Vector3d& at, const Mannequin& form);

// How much laying the target flat distorts it, by garment triangle: mean |sigma - 1| of the map from `flat` to the target.
Eigen::VectorXd flattening_distortion(const Target& target, const RestShape& flat);

struct Judged {
  const Target& target;
  const Adjustment& adjustment;
  const Verified& verified;
  double seam_mismatch = 0;  // m, of the redrawn pattern
  TailoringDifference tailoring;
  const Mannequin& form;
};

// Errors "adjust.not-developable", "adjust.slips", "adjust.far-from-target" (above 1 % of the height; "adjust.cutting-rules"
// where plain flattening comes much nearer), "adjust.seam-mismatch" (above 3 mm), each with its place on the garment; the
// warning "adjust.other-folds" where only folds fall otherwise.
Report judge(const Judged& judged);

}  // namespace toile
