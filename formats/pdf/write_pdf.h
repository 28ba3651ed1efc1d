#pragma once
// The cut sheet as PDF at true size, lines and text as such: one page, or tiles for a printer.

#include <filesystem>
#include <optional>
#include <string>

#include "formats/svg/sheet_style.h"
#include "garment/cut_sheet.h"

namespace toile {

struct PrintOptions {
  std::string paper = "roll";  // or one of papers.h
  double margin = 10e-3;       // m, that the printer cannot print on
  double overlap = 10e-3;      // m, that two neighbours both show: to glue on
};

// What cannot be printed so: "pdf.no-such-paper", "pdf.margin", "pdf.overlap"; the place is "paper", "margin" or "overlap".
std::optional<Finding> fault_of(const PrintOptions& options);

// "roll": one page as the SVG is (write_svg.h), without its white ground; longer than a PDF's page may be (5,080 mm), it goes
// on on further pages. Another paper: pages of that size, upright: notes, test squares and a map of the pages first, then every
// page that something is drawn on, row by row (tile_frame.h). The same sheet is the same bytes. Throws BadInput: those of
// fault_of, "pdf.too-many-pages", "svg.empty-sheet".
std::string pdf_bytes(const CutSheet& sheet, const SheetStyle& style = {}, const PrintOptions& options = {});

// Also throws BadInput "file.cannot-create".
void write_pdf(const std::filesystem::path& file, const CutSheet& sheet, const SheetStyle& style, const PrintOptions& options);

}  // namespace toile
