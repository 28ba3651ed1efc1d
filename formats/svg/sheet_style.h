#pragma once
// How a cut sheet looks: templates/cut_sheets/NAME.toml; the README there has the keys. Metres.

#include <filesystem>
#include <string>
#include <vector>

#include "garment/report.h"

namespace toile {

struct LineStyle {
  std::string colour = "#000000";  // #rrggbb
  double width = 0.35e-3;          // m
  std::vector<double> dash;        // m, drawn and left out in turn; empty: solid
  bool shown = true;
  bool operator==(const LineStyle&) const = default;
};

struct SheetStyle {
  LineStyle cut{.colour = "#000000", .width = 0.5e-3, .dash = {}, .shown = true};
  LineStyle sew{.colour = "#1b4f9c", .width = 0.35e-3, .dash = {5e-3, 2.5e-3}, .shown = true};
  LineStyle notch{.colour = "#c0141c", .width = 0.5e-3, .dash = {}, .shown = true};
  LineStyle grain{.colour = "#000000", .width = 0.35e-3, .dash = {}, .shown = true};
  LineStyle internal{.colour = "#4a4a4a", .width = 0.35e-3, .dash = {}, .shown = true};
  LineStyle drill{.colour = "#c0141c", .width = 0.35e-3, .dash = {}, .shown = true};
  LineStyle turn_points{.colour = "#1b4f9c", .width = 0.25e-3, .dash = {}, .shown = false};
  LineStyle frame{.colour = "#000000", .width = 0.35e-3, .dash = {}, .shown = true};  // test squares and legend
  std::string font = "DejaVu Sans, Verdana, Arial, sans-serif";
  std::string text_colour = "#000000";
  double largest_text = 6e-3;   // m, letter size of piece labels where there is room
  double smallest_text = 2e-3;  // m, where there is not
  double heading_text = 4e-3;   // m, notes and legend; the title is twice as large
  bool operator==(const SheetStyle&) const = default;
};

// Errors "sheet-style.unknown-key", "sheet-style.bad-value" with file and line, and those of reading a TOML file.
Loaded<SheetStyle> read_sheet_style(const std::filesystem::path& file);

}  // namespace toile
