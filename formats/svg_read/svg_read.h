#pragma once
// SVG patterns of FreeSewing, Valentina, Seamly, Inkscape, Illustrator, GarmentCode and Toile itself, and plain drawings.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

// Net pieces in metres. `size`: of a drawing with several; empty: the first. Findings begin with "file." or "svg." and name
// file and line or piece; what is drawn and is no part of a piece is counted in "svg.outside" and "svg.left-out".
Loaded<PatternFile> read_svg(const std::filesystem::path& file, std::optional<double> unit_in_metres = {},
                             const std::string& size = {});
Loaded<PatternFile> read_svg_bytes(std::string_view bytes, const std::string& name, std::optional<double> unit_in_metres = {},
                                   const std::string& size = {});

bool looks_like_svg(std::string_view bytes);

}  // namespace toile
