#pragma once
// The grade rule table that belongs to a DXF.

#include <filesystem>
#include <optional>
#include <string>

namespace toile::aama {

// In the DXF's folder, whatever the case of the letters: NAME.rul beside NAME.dxf, else the table the DXF names (with or
// without its extension).
std::optional<std::filesystem::path> rules_beside(const std::filesystem::path& dxf, const std::string& table_name);

}  // namespace toile::aama
