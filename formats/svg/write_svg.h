#pragma once
// The cut sheet as SVG at true size: width and height in mm and a viewBox in mm, so that one user unit is one millimetre.

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "formats/svg/sheet_style.h"
#include "garment/cut_sheet.h"

namespace toile {

enum class SheetParts {
  whole,       // white page, heading, pieces
  uncoloured,  // heading and pieces: a printer's page is white by itself
  pieces,      // alone, on a page of the sheet's size
  outlines,    // the pieces' cut lines, filled with a light grey, on a page of the sheet's size
};

// The page is as wide as the sheet and longer by a heading at the top (title, notes, test squares of 50 mm and 2 in, legend).
// Every piece is a group with data-piece; every line in it has data-type (cut, sew, notch, grain, internal, cut-out, drill,
// turn), data-piece and, where it belongs to one, data-edge; a sewn edge has data-seam "NAME/a" or "NAME/b", separated by ";".
// Throws BadInput "svg.empty-sheet" when there is nothing to draw, std::invalid_argument for coordinates that are not finite.
std::string svg_text(const CutSheet& sheet, const SheetStyle& style = {}, SheetParts parts = SheetParts::whole);

// Width and height of its page, mm.
Eigen::Vector2d svg_size(const CutSheet& sheet, const SheetStyle& style, SheetParts parts);

// Also throws BadInput "file.cannot-create".
void write_svg(const std::filesystem::path& file, const CutSheet& sheet, const SheetStyle& style);

}  // namespace toile
