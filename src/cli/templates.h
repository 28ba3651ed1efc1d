#pragma once

#include <filesystem>
#include <string>

namespace toile {

// A file of templates/ (garment/templates.h). Throws BadInput("template.missing") listing what its folder has.
std::filesystem::path template_file(const std::string& folder, const std::string& name);

}  // namespace toile
