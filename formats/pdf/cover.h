#pragma once
// The pages before the tiles: what to check and how to tape, the certificate, test squares, the map of the pages.

#include <optional>
#include <string>
#include <vector>

#include "formats/pdf/drawing.h"
#include "formats/pdf/tiling.h"
#include "formats/svg/sheet_style.h"
#include "garment/cut_sheet.h"

namespace toile {

struct CoverPage {
  std::string svg;             // of the page's size
  std::optional<PageBox> map;  // where the small sheet is drawn, below the SVG
  double scale = 0;            // of it
};

// One page where the map has room below the notes, else two.
std::vector<CoverPage> cover_pages(const CutSheet& sheet, const TilePlan& plan, const SheetStyle& style);

}  // namespace toile
