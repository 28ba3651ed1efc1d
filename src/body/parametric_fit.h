#pragma once
// Turns the scales of a form until its surface measures what the figure says.

#include "body/parametric_form.h"

namespace toile {

// Where a girth is taken on the body: round `at`, in the plane with normal `along`.
struct TapePlace {
  Eigen::Vector3d at, along;
  bool trunk = false;
};

// By girth name; "thigh" is 2 cm below the crotch, "upper_arm" at .55 of the upper arm, "neck" half way up the neck.
std::map<std::string, TapePlace> tape_places(const Figure& figure);

// Taped girth of the solid, m, by rays from `place.at`.
double tape_on_form(const BodyForm& form, const TapePlace& place);

// Scales that reach all girths of the figure to about a millimetre where the body allows it.
FormScales fitted_scales(const Figure& figure);

}  // namespace toile
