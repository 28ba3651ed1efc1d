#pragma once
// The findings of the piece builder shared with DXF, in the words of an SVG.

#include "garment/report.h"

namespace toile::svg {

// "aama.no-sew-line" becomes "svg.no-sew-line", with texts and remedies that speak of lines instead of layers.
void append_in_svg_words(const Report& from, Report& to);

}  // namespace toile::svg
