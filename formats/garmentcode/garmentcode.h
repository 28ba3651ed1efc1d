#pragma once
// GarmentCode pattern specifications (NAME_specification.json): panels with curves, stitches, and where each panel hangs.

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "garment/pattern.h"
#include "garment/pattern_file.h"
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

// What the file says about itself besides; `unit_in_metres` overrides its unit. A panel of a partial file may lack its place
// (warning "garmentcode.no-placement"); notes "garmentcode.unknown-keys" name what was left aside.
Loaded<PatternFile> read_garmentcode_file(const std::filesystem::path& file, std::optional<double> unit_in_metres = {});
Loaded<PatternFile> read_garmentcode_text(const std::string& text, const std::filesystem::path& file,
                                          std::optional<double> unit_in_metres = {});

// A specification in centimetres from which the same pieces, seams and places are read again: every copy is a panel; edges are
// lines, circles and Bezier curves within 0.05 mm of their points; an edge that is no single curve, or that a seam joins in
// part, is several. What the format cannot hold is in the report ("garmentcode.no-notch", ...). Throws std::invalid_argument
// for a seam that names what is not there.
std::pair<std::string, Report> garmentcode_text(const Pattern& pattern);

}  // namespace toile
