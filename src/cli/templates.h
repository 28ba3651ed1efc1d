#pragma once

#include <filesystem>
#include <string>

namespace toile {

// A file of templates/: under $TOILE_TEMPLATES, else beside the installed program, else in the source tree. Throws
// BadInput("template.missing") listing what its folder has.
std::filesystem::path template_file(const std::string& folder, const std::string& name);

}  // namespace toile
