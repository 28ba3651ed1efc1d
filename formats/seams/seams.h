#pragma once
// NAME.seams.toml: what a DXF pattern does not say — the names of its edges, what is sewn to what, and where each piece sits on
// the body. README.md has the format.

#include <filesystem>

#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

// Reads `sidecar` into `pattern`, whose pieces it names: edges, copies, hems, allowances, body parts; its seams are appended to
// the pattern's. When the report is not ok the pattern is as it was.
Report apply_seams(Pattern& pattern, const std::filesystem::path& sidecar);

// The same from text; `file` is only named in findings.
Report apply_seams(Pattern& pattern, const std::string& text, const std::string& file);

// The text of a sidecar from which apply_seams takes the same edge names, hems, allowances, copies, placement and seams again
// when the pattern's outlines are read from elsewhere (each piece's first turn point is found by its corner or its
// coordinates).
std::string seams_text(const Pattern& pattern);

}  // namespace toile
