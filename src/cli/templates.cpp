#include "cli/templates.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "garment/report.h"

namespace toile {

namespace fs = std::filesystem;

namespace {

fs::path root() {
  if (const char* given = std::getenv("TOILE_TEMPLATES")) return given;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share" / "toile" / "templates";
  if (!error && fs::is_directory(installed, error)) return installed;
  return TOILE_TEMPLATE_FOLDER;
}

}  // namespace

fs::path template_file(const std::string& folder, const std::string& name) {
  const fs::path file = root() / folder / name;
  std::error_code error;
  if (fs::is_regular_file(file, error)) return file;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(root() / folder, error))
    if (entry.path().extension() == file.extension()) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  throw BadInput({"template.missing", Severity::error, file.string(), "there is no '" + fs::path(name).stem().string() + "'",
                  list.empty() ? "Set TOILE_TEMPLATES to the templates folder" : "There are: " + list, Fault::missing});
}

}  // namespace toile
