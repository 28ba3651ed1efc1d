#pragma once
// A replica of the dressed body at another size (paper Sec. 6, Fig. 12): everything smaller by one factor but the cloth.

#include "body/body.h"
#include "garment/pattern.h"
#include "garment/target.h"

namespace toile {

// Every length times `factor`, allowances and notches included.
Pattern scaled(Pattern pattern, double factor);
Mannequin scaled(Mannequin form, double factor);

// A seam allowance of a replica: scaled, but no narrower than can be sewn (4 mm) unless it was; m.
double replica_allowance(double allowance, double factor);

// `target`, of a garment cut from `pattern` and worn on `body`, on a body `height` (m) tall. What it is cut from follows the
// target; the fabric does not: it is stiffer and lighter for its size, which the adjustment has to make good. Throws BadInput
// "replica.bad-height" when the body would be less than a twentieth or more than twice as tall.
Target replica(const Target& target, const Pattern& pattern, const Body& body, double height);

}  // namespace toile
