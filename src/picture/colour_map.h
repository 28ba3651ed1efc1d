#pragma once
// Colours for numbers: evenly darker from pale to deep, so that equal steps look equal, also to the colour-blind and in grey.

#include <string>
#include <vector>

#include "picture/image.h"

namespace toile {

// t from 0 (pale) to 1 (deep), clamped; grey when not a number.
Colour colour_map(double t);

// t from -1 (deep blue) over 0 (nearly white) to 1 (deep red), clamped, as evenly; grey when not a number.
Colour signed_colour_map(double t);

// What a colour means.
struct ColourScale {
  double top = 1;  // value of the deepest colour; 0 is the palest
  double low = 0;  // value at the other end: 0, or -top on a scale of two colours
  std::string unit = "mm";
  std::string title;  // "distance to the target"
};

// The smallest of 1, 2, 3, 4, 5, 6, 8 times a power of ten that is at least `value`; 1 for 0 or less.
double round_top(double value);
// Round values from 0 to a round `top`, in four to six steps.
std::vector<double> ticks(double top);

}  // namespace toile
