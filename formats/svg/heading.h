#pragma once
// What stands above the pieces of a cut sheet: title, notes, test squares, legend.

#include <functional>
#include <vector>

#include "formats/svg/sheet_style.h"
#include "formats/svg/xml_text.h"
#include "garment/cut_sheet.h"

namespace toile {

struct Heading {
  double height = 0;                                  // mm
  std::vector<std::function<void(XmlText&)>> blocks;  // each draws itself at its place
};

// `width`: of the page, mm. Blocks stand side by side and go on below where the page is too narrow.
Heading heading_of(const CutSheet& sheet, const SheetStyle& style, double width);

// The root of a drawing of that size in mm, one user unit a millimetre.
XmlText& open_page(XmlText& xml, double width, double height);

// Attributes of a line: fill, stroke, width, dash.
XmlText& drawn(XmlText& xml, const LineStyle& line, const char* fill = "none");
// Attributes of text of `size` mm.
XmlText& lettered(XmlText& xml, const SheetStyle& style, double size);

}  // namespace toile
