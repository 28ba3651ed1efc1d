#pragma once
// GarmentCode pattern specifications (NAME_specification.json): panels with curves, stitches, and where each panel hangs.

#include <filesystem>

#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

// Guarantees about the pattern:
//  1. Piece::outline[k] is edge k of the file's panel; its id is the file's label where that is the only one in the panel, else
//  "e<k>".
//  2. Curves are sampled so that no chord departs from its curve by more than 0.05 mm.
//  3. Every outline is counter-clockwise. The format turns a panel's outside to the side from which its loop runs
//  counter-clockwise;
//     a loop given clockwise is drawn mirrored (x, y) -> (-x, y), and its placement turned by half a turn about the panel's y
//     axis, so that every point stays where the file hangs it and rotation * +Z is the outside.
//  4. A stitch is one seam: beginning of the first edge to the end of the second; beginning to beginning when "right_wrong".
// The format knows no grain line (the grain is the panel's y axis), allowances, notches or fabric.
// Errors: "json.syntax" with line and column, "garmentcode.*" and "seam.*" naming panel, edge or stitch.
Loaded<Pattern> read_garmentcode(const std::filesystem::path& file);

// The same from text; `file` is named in findings and gives the pattern its name.
Loaded<Pattern> read_garmentcode(const std::string& text, const std::filesystem::path& file);

}  // namespace toile
