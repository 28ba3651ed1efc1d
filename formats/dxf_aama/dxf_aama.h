#pragma once
// AAMA/ASTM pattern DXF. README.md beside this file says what real files do.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "formats/rul/rul.h"
#include "garment/cut_sheet.h"
#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

struct PatternReadOptions;

// All the file holds: pieces of the sample size or of options.size, net line, metres, edges "e0", "e1", ...; graded by the nest
// it is, or by the rule table beside it (NAME.rul, or the table it names). Findings begin with "file." (cannot be read), "dxf."
// (is no whole DXF), "rul." or "aama."; each names file and line or piece.
Loaded<PatternFile> read_dxf_pattern(const std::filesystem::path& file, const PatternReadOptions& options);

// Where the rule table of a file is to be had that has grade rule numbers and is no nest; `named` is what the file calls it.
using FindRules = std::function<std::optional<GradeTable>(const std::string& named, Report& report)>;

// The same for bytes in memory; `name` is what findings call them, and the pattern when the file has no style name.
Loaded<PatternFile> read_dxf_pattern_bytes(std::string_view bytes, const std::string& name, const PatternReadOptions& options,
                                           const FindRules& find_rules = {});

// The pattern alone.
Loaded<Pattern> read_dxf_aama(const std::filesystem::path& file, std::optional<double> unit_in_metres = {});
Loaded<Pattern> read_dxf_aama_bytes(std::string_view bytes, const std::string& name, std::optional<double> unit_in_metres = {});

// The file write_dxf_aama writes: R12 without header variables or tables, mm with four digits, one block per piece in its own
// coordinates, 7-bit ASCII. Throws std::invalid_argument when a piece has no outline, no cut line or a coordinate that is not
// finite.
std::string dxf_aama_bytes(const CutSheet& sheet);

}  // namespace toile
