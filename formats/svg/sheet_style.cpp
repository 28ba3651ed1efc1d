#include "formats/svg/sheet_style.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "formats/formats.h"
#include "formats/toml/toml.h"
#include "garment/units.h"

namespace toile {
namespace {

struct LineKey {
  const char* table;
  LineStyle SheetStyle::*line;
};
constexpr std::array line_keys = {LineKey{"cut", &SheetStyle::cut},
                                  LineKey{"sew", &SheetStyle::sew},
                                  LineKey{"notch", &SheetStyle::notch},
                                  LineKey{"grain", &SheetStyle::grain},
                                  LineKey{"internal", &SheetStyle::internal},
                                  LineKey{"drill", &SheetStyle::drill},
                                  LineKey{"turn_points", &SheetStyle::turn_points},
                                  LineKey{"frame", &SheetStyle::frame}};

bool is_colour(const std::string& text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(), [](unsigned char c) { return std::isxdigit(c); });
}

class StyleReader {
 public:
  StyleReader(const std::string& file, Report& report) : file_(file), report_(report) {}

  void bad(const TomlNode& node, const std::string& wanted) {
    report_.error("sheet-style.bad-value", toml_place(file_, node), "'" + node.key + "' is not " + wanted, "write " + wanted);
  }

  void length(const TomlNode& table, const char* key, double& value) {
    const TomlNode* node = find(table, key);
    if (!node) return;
    const auto read = node->kind == TomlKind::text ? parse_length(node->text) : std::nullopt;
    if (read && *read > 0 && *read < 1)
      value = *read;
    else
      bad(*node, "a length with its unit, such as \"0.5 mm\"");
  }

  void words(const TomlNode& table, const char* key, std::string& value) {
    const TomlNode* node = find(table, key);
    if (!node) return;
    if (node->kind == TomlKind::text)
      value = node->text;
    else
      bad(*node, "a text in quotes");
  }

  void colour(const TomlNode& table, const char* key, std::string& value) {
    const TomlNode* node = find(table, key);
    if (!node) return;
    if (node->kind == TomlKind::text && is_colour(node->text))
      value = node->text;
    else
      bad(*node, "a colour such as \"#1b4f9c\"");
  }

  void line(const TomlNode& table, LineStyle& line) {
    if (table.kind != TomlKind::table) return bad(table, "a table of colour, width, dash, shown");
    refuse_unknown_keys(table, {"colour", "width", "dash", "shown"}, file_, "sheet-style.unknown-key", report_);
    colour(table, "colour", line.colour);
    length(table, "width", line.width);
    if (const TomlNode* shown = find(table, "shown")) {
      if (shown->kind == TomlKind::boolean)
        line.shown = shown->truth;
      else
        bad(*shown, "true or false");
    }
    const TomlNode* dash = find(table, "dash");
    if (!dash) return;
    line.dash.clear();
    if (dash->kind != TomlKind::array) return bad(*dash, "a list of lengths such as [\"5 mm\", \"2.5 mm\"]");
    for (const TomlNode& part : dash->items) {
      const auto read = part.kind == TomlKind::text ? parse_length(part.text) : std::nullopt;
      if (!read || *read < 0) return bad(*dash, "a list of lengths such as [\"5 mm\", \"2.5 mm\"]");
      line.dash.push_back(*read);
    }
  }

 private:
  const std::string& file_;
  Report& report_;
};

}  // namespace

Loaded<SheetStyle> read_sheet_style(const std::filesystem::path& file) {
  Loaded<SheetStyle> loaded;
  const auto bytes = read_whole_file(file);
  loaded.report = bytes.report;
  if (!bytes.value) return loaded;
  const std::string name = file.string();
  const auto root = parse_toml(*bytes.value, name);
  loaded.report.append(root.report);
  if (!root.value) return loaded;
  refuse_unknown_keys(*root.value, {"cut", "sew", "notch", "grain", "internal", "drill", "turn_points", "frame", "text"}, name,
                      "sheet-style.unknown-key", loaded.report);
  SheetStyle style;
  StyleReader reader(name, loaded.report);
  for (const LineKey& key : line_keys)
    if (const TomlNode* table = find(*root.value, key.table)) reader.line(*table, style.*key.line);
  if (const TomlNode* text = find(*root.value, "text")) {
    refuse_unknown_keys(*text, {"font", "colour", "largest", "smallest", "heading"}, name, "sheet-style.unknown-key",
                        loaded.report);
    reader.words(*text, "font", style.font);
    reader.colour(*text, "colour", style.text_colour);
    reader.length(*text, "largest", style.largest_text);
    reader.length(*text, "smallest", style.smallest_text);
    reader.length(*text, "heading", style.heading_text);
  }
  if (loaded.report.ok()) loaded.value = std::move(style);
  return loaded;
}

}  // namespace toile
