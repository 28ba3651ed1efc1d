#pragma once
// A mannequin made ready for draping and editing.

#include "body/distance_field.h"
#include "body/triangle_tree.h"
#include "garment/mannequin.h"
#include "garment/report.h"

namespace toile {

struct Body {
  Mannequin form;
  DistanceField distance;
  TriangleTree skin;
};

// Throws BadInput ("body.not-closed", "body.not-finite", "body.not-in-metres", ...) naming the body and the remedy.
Body make_body(Mannequin form);

// Errors and warnings about a body read from a file: holes, orientation, scale, self-intersection, missing skeleton.
Report check_body(const Mannequin& form, const std::string& place);

// The height above the floor that `name` means on this body: a landmark, or "BONE:0.4" (fraction along a bone).
// Throws BadInput("body.no-such-level") listing the landmarks there are.
double level_height(const Mannequin& form, const std::string& name);

}  // namespace toile
