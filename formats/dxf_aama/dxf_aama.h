#pragma once
// AAMA/ASTM pattern DXF. README.md beside this file says what real files do.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "garment/cut_sheet.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

// The pieces of the sample size, net line, metres, edges "e0", "e1", ... Findings begin with "file." (cannot be read), "dxf."
// (is no whole DXF) or "aama."; each names file and line or piece.
Loaded<Pattern> read_dxf_aama(const std::filesystem::path& file, std::optional<double> unit_in_metres = {});

// The same for bytes in memory; `name` is what findings call them, and the pattern when the file has no style name.
Loaded<Pattern> read_dxf_aama_bytes(std::string_view bytes, const std::string& name, std::optional<double> unit_in_metres = {});

// The file write_dxf_aama writes: R12 without header variables or tables, mm with four digits, one block per piece in its own
// coordinates, 7-bit ASCII. Throws std::invalid_argument when a piece has no outline, no cut line or a coordinate that is not
// finite.
std::string dxf_aama_bytes(const CutSheet& sheet);

}  // namespace toile
