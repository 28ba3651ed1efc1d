#pragma once
// A garment draped elsewhere as OBJ with texture coordinates: the islands of vt are its pieces, v is its drape. README.md
// beside this file says what is made of what programs write.

#include <filesystem>
#include <optional>
#include <string>

#include "garment/pattern_file.h"
#include "garment/report.h"

namespace toile {

// The pieces (net), their seams and the drape. Findings begin with "obj." (islands.h, garment_scale.h, garment_piece.h,
// coincident_seams.h) and name line and piece.
Loaded<PatternFile> read_obj_garment(const std::filesystem::path& file, std::optional<double> unit_in_metres = {});
Loaded<PatternFile> read_obj_garment(const std::string& text, const std::string& place,
                                     std::optional<double> unit_in_metres = {});

}  // namespace toile
