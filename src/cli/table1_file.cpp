#include "cli/table1_file.h"

#include "formats/formats.h"
#include "garment/tomlplusplus.inc"

namespace toile {

Loaded<std::vector<TableRow>> read_table1(const std::filesystem::path& file) {
  Loaded<std::vector<TableRow>> loaded;
  const Loaded<std::string> text = read_whole_file(file);
  loaded.report = text.report;
  if (!text.value) return loaded;
  std::vector<TableRow> rows;
  try {
    const toml::table root = toml::parse(*text.value);
    const toml::array* list = root["row"].as_array();
    for (std::size_t i = 0; list && i < list->size(); ++i) {
      const auto row = toml::node_view(list->get(i));
      const auto paper = row["paper"];
      const auto triangles = paper["triangles"].value<int64_t>();
      const auto number = [&](const char* key) { return paper[key].value<double>(); };
      const auto name = row["name"].value<std::string>(), what = row["what"].value<std::string>(),
                 recipe = row["recipe"].value<std::string>();
      const auto flat_s = number("flattened_stretch"), s = number("stretch"), flat_h = number("flattened_hausdorff"),
                 h = number("hausdorff");
      if (!name || !what || !recipe || !triangles || !flat_s || !s || !flat_h || !h) {
        loaded.report.error("table1.incomplete", file.string() + ":" + std::to_string(list->get(i)->source().begin.line),
                            "a row lacks something",
                            "A row has name, what, recipe, and paper = { triangles, flattened_stretch, stretch, "
                            "flattened_hausdorff, hausdorff }");
        return loaded;
      }
      rows.push_back({*name, *what, file.parent_path() / *recipe, {static_cast<int>(*triangles), *flat_s, *s, *flat_h, *h}});
    }
  } catch (const toml::parse_error& error) {
    loaded.report.error("table1.not-toml", file.string() + ":" + std::to_string(error.source().begin.line),
                        std::string(error.description()), "Correct the table there");
    return loaded;
  }
  loaded.value = std::move(rows);
  return loaded;
}

}  // namespace toile
