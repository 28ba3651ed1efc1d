#include "formats/dxf_aama/rules_beside.h"

#include <algorithm>
#include <vector>

#include "formats/dxf/tags.h"

namespace toile::aama {

std::optional<std::filesystem::path> rules_beside(const std::filesystem::path& dxf, const std::string& table_name) {
  std::error_code failed;
  const std::filesystem::path folder = dxf.has_parent_path() ? dxf.parent_path() : std::filesystem::path(".");
  std::vector<std::filesystem::path> tables;
  for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (dxf::same_word(entry->path().extension().string(), ".rul")) tables.push_back(entry->path());
  std::sort(tables.begin(), tables.end());
  const auto called = [&](const std::string& name) -> std::optional<std::filesystem::path> {
    for (const std::filesystem::path& table : tables)
      if (table.stem().string() == name || table.filename().string() == name) return table;
    for (const std::filesystem::path& table : tables)
      if (dxf::same_word(table.stem().string(), name) || dxf::same_word(table.filename().string(), name)) return table;
    return {};
  };
  if (const auto beside = called(dxf.stem().string())) return beside;
  return table_name.empty() ? std::nullopt : called(table_name);
}

}  // namespace toile::aama
