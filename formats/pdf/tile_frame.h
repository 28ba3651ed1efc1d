#pragma once
// What a tile shows beside its part of the sheet: its name and its neighbours', where it is cut and glued, marks that meet the
// neighbour's, bars to measure.

#include <string>

#include "formats/pdf/tiling.h"
#include "formats/svg/sheet_style.h"

namespace toile {

// An SVG of the page's size, to be drawn below the pieces. `title`: of the sheet; `page` of `pages` of the file, from 1.
//
// Of two neighbours the right (lower) one is cut along its frame and laid on the left (upper) one up to the dashed line there;
// half diamonds on both then are whole ones.
std::string tile_frame(const TilePlan& plan, int row, int column, const std::string& title, int page, int pages,
                       const SheetStyle& style);

}  // namespace toile
