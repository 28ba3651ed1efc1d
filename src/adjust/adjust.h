#pragma once
// Pattern adjustment (paper Sec. 4): rest shapes whose drape is the target, by the fixed point of Eq. 6-7.

#include <functional>

#include "garment/adjustment.h"
#include "garment/target.h"

namespace toile {

// Phi: drape of `garment` started at `start`, settled to `tolerance`.
using Simulate = std::function<Drape(const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double tolerance)>;

// Nearest rest shape that can be cut: smooth outlines, straight edges straight, identical pieces identical.
using MakeCuttable = std::function<RestShape(const RestShape&)>;

struct AdjustOptions {
  int most_steps = 5;
  double damping = 0.7;           // gain of step k is damping^k
  double tolerance = 1e-3;        // of Phi inside the loop
  double agreed_hausdorff = 1e-3; // m: stop when the drape is this near to the target
  double stalled_ratio = 0.97;    // stop when a step improves the distance by less than this factor
  double slip_limit = 0.01;       // share of the garment's height extent: more rigid drop than that is "slipped"
  double developable_limit = 0.02;  // mean distortion of the flattening above which the target cannot be cut from flat cloth
  std::function<void(const AdjustStep&)> progress = {};
};

Adjustment adjust(const Target& target, const Simulate& simulate, const MakeCuttable& make_cuttable,
                  const AdjustOptions& options = {});

}  // namespace toile
