#pragma once
// Heights of the body's levels, measured on its shape when nobody has said them.

#include <map>
#include <string>

#include "garment/mannequin.h"

namespace toile {

// Lowest and highest y of the triangles, m.
struct UprightExtent {
  double low = 0, high = 0;
};
UprightExtent upright_extent(const Mannequin& form);

// "waist": least girth of the trunk between .55 and .70 of the height; "bust": largest girth between .68 and .745 of it;
// "crotch": where the section parts into two legs, when the thighs do not touch; "nape", "shoulder", "knee": of the bones, when
// there are some. The rest, and these where the shape does not say, by proportion: "hip" (girth only grows from there to the
// crotch, so no shape shows it), "high_hip" (halfway from hip to waist), "underbust", "armpit", "ankle". Heights above the
// floor, m. `form` closed, upright, in metres.
std::map<std::string, double> measured_landmarks(const Mannequin& form);

}  // namespace toile
