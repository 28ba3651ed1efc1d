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
  int most_steps = 5;               // drapes beside the flattening's
  double damping = 0.7;             // gain of step k is damping^k
  double tolerance = 1e-3;          // of Phi inside the loop
  double agreed_hausdorff = 1e-3;   // m: stop when the drape is this near to the target
  double stalled_ratio = 0.97;      // stop when a step improves the distance by less than this factor
  double slip_limit = 0.01;         // share of the garment's height extent: more rigid drop than that is "slipped"
  double developable_limit = 0.02;  // mean distortion of laying the target flat above which it cannot be cut from flat cloth
  // First guess T = A^-1 t^g with A from the source drape (Eq. 6), which costs no drape. Without it, or when it is no nearer
  // than the flattening, the iteration starts from the flattening as the paper does.
  bool start_from_source = true;
  bool undo_compression = true;  // Eq. 9, when starting from the flattening, on panels with an eased seam
  std::function<void(const AdjustStep&)> progress = {};
};

// Guarantees:
//  1. steps[0] is the plain flattening of the target, draped: no seam ratio, no cutting rules, no physics.
//  2. Every other step is a rest shape that went through `make_cuttable` (empty: unchanged), draped from the target.
//  3. `rest`, `drape` and `best` are the step, the flattening aside, whose drape is nearest to the target by Hausdorff
//  distance; a
//     drape that did not come to rest never beats one that did, because it still lies where it was started.
//  4. A step starts from the nearest drape so far, the flattening's included; one that is no nearer is tried once more, half as
//  far,
//     before "stalled". When none is nearer than the flattening, the flattening made cuttable is the last step.
// `not_developable` is known before simulating: the target laid flat, with the stretch of the source drape taken out, is
// distorted by more than the limit. Only the flattening is draped then, and `best` is 0. Throws std::invalid_argument when
// sizes differ.
Adjustment adjust(const Target& target, const Simulate& simulate, const MakeCuttable& make_cuttable,
                  const AdjustOptions& options = {});

// What can be said of `rest` once it hangs as `drape`: every field of a step but embedding_distortion and seconds (of the
// drape).
AdjustStep measure(const Target& target, const RestShape& rest, const Drape& drape);

}  // namespace toile
