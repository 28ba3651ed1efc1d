#pragma once
// sRGB, linear light (IEC 61966-2-1) and OKLab (B. Ottosson 2020).

#include "picture/image.h"

namespace toile {

struct OkLab {
  double lightness = 0, a = 0, b = 0;
};

double to_linear(double srgb);
double to_encoded(double linear);

Colour to_srgb(const OkLab& lab);  // clamped to what a screen shows
OkLab to_oklab(const Colour& srgb);

}  // namespace toile
