#pragma once

#include <filesystem>
#include <string>

namespace toile {

// A folder of templates/, "fabrics": under $TOILE_TEMPLATES, else beside the installed program, else in the source tree.
std::filesystem::path template_folder(const std::string& name);

}  // namespace toile
