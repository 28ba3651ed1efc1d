#pragma once
// templates/garments/*.toml: what garments are made of. templates/garments/README.md has the format.

#include <filesystem>
#include <string>
#include <vector>

#include "garment/garment_template.h"
#include "garment/report.h"

namespace toile {

// One template; `words` (front, back, left, ...) come from words.toml. `file` is only named in findings: "toml.syntax",
// "garment-template.bad-value", "garment-template.unknown-key", "garment-template.unknown-role".
Loaded<GarmentTemplate> read_garment_template(const std::string& bytes, const std::string& file);

// All of a folder, by file name, each with the words of its words.toml. Errors as above and "template.missing".
Loaded<std::vector<GarmentTemplate>> read_garment_templates(const std::filesystem::path& folder);

}  // namespace toile
