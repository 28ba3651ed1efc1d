#include "cli/templates.h"

#include <algorithm>
#include <vector>

#include "garment/report.h"
#include "garment/templates.h"

namespace toile {

namespace fs = std::filesystem;

fs::path template_file(const std::string& folder, const std::string& name) {
  const fs::path file = template_folder(folder) / name;
  std::error_code error;
  if (fs::is_regular_file(file, error)) return file;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(template_folder(folder), error))
    if (entry.path().extension() == file.extension()) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  throw BadInput({"template.missing", Severity::error, file.string(), "there is no '" + fs::path(name).stem().string() + "'",
                  list.empty() ? "Set TOILE_TEMPLATES to the templates folder" : "There are: " + list, Fault::missing});
}

}  // namespace toile
