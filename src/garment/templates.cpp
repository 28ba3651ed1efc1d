#include "garment/templates.h"

#include <cstdlib>

namespace toile {

namespace fs = std::filesystem;

fs::path template_folder(const std::string& name) {
  if (const char* given = std::getenv("TOILE_TEMPLATES")) return fs::path(given) / name;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "toile" / "templates";
  return (!error && fs::is_directory(installed, error) ? installed : fs::path(TOILE_TEMPLATE_FOLDER)) / name;
}

}  // namespace toile
