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

// Throws BadInput ("body.not-closed", "body.not-finite", "body.not-in-metres", ...) naming the body and the remedy. Landmarks
// that `form` does not have are measured on its shape (landmarks.h). Bodies below 1.6 m get a proportionally finer distance
// field.
Body make_body(Mannequin form);

enum class SelfIntersections { looked_for, not_looked_for };

// Errors and warnings about a body read from a file: holes, orientation, scale, self-intersection, missing skeleton.
Report check_body(const Mannequin& form, const std::string& place,
                  SelfIntersections intersections = SelfIntersections::looked_for);

// The height above the floor that `name` means on this body: a landmark, or "BONE:0.4" (fraction along a bone).
// Throws BadInput("body.no-such-level") listing the landmarks there are.
double level_height(const Mannequin& form, const std::string& name);

}  // namespace toile
