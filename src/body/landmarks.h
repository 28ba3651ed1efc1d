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

// "waist": least girth of the trunk between .55 and .70 of the height; "crotch": where the section parts into two legs; "hip":
// largest girth between them; "high_hip": halfway from hip to waist; "bust": largest girth between .68 and .745 of the height;
// "nape", "shoulder", "knee", "ankle": of the bones when there are some, else by proportion, like "underbust" and "armpit".
// Heights above the floor, m. `form` closed, upright, in metres.
std::map<std::string, double> measured_landmarks(const Mannequin& form);

}  // namespace toile
