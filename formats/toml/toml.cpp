#include "formats/toml/toml.h"

#include <algorithm>
#include <sstream>

#include "garment/tomlplusplus.inc"

namespace toile {
namespace {

TomlNode plain(const toml::node& node) {
  TomlNode out;
  out.line = static_cast<int>(node.source().begin.line);
  if (const auto* table = node.as_table()) {
    out.kind = TomlKind::table;
    for (const auto& [key, value] : *table) {
      out.items.push_back(plain(value));
      out.items.back().key = std::string(key.str());
      // An array of tables begins at its first table, an implicit table nowhere: name the key's own line.
      if (key.source().begin.line > 0) out.items.back().line = static_cast<int>(key.source().begin.line);
    }
    std::stable_sort(out.items.begin(), out.items.end(), [](const TomlNode& a, const TomlNode& b) { return a.line < b.line; });
  } else if (const auto* array = node.as_array()) {
    out.kind = TomlKind::array;
    for (const toml::node& item : *array) out.items.push_back(plain(item));
  } else if (const auto* text = node.as_string()) {
    out.kind = TomlKind::text;
    out.text = text->get();
  } else if (const auto* integer = node.as_integer()) {
    out.kind = TomlKind::integer;
    out.number = static_cast<double>(integer->get());
  } else if (const auto* real = node.as_floating_point()) {
    out.kind = TomlKind::real;
    out.number = real->get();
  } else if (const auto* truth = node.as_boolean()) {
    out.kind = TomlKind::boolean;
    out.truth = truth->get();
  } else {
    out.kind = TomlKind::date;
  }
  return out;
}

bool takes_for_granted(std::string_view text) {
  try {
    static_cast<void>(toml::parse(text));
  } catch (const toml::parse_error&) {
    return false;
  } catch (const TomlTakenForGranted&) {
    return true;
  }
  return false;
}

// The line up to which `bytes` must be read for the parser to meet what it takes for granted.
std::ptrdiff_t line_of_what_is_broken(std::string_view bytes) {
  std::vector<std::size_t> ends;
  for (std::size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) ends.push_back(at + 1);
  ends.push_back(bytes.size());
  const auto first =
      std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) { return !takes_for_granted(bytes.substr(0, end)); });
  return 1 + std::min(first - ends.begin(), static_cast<std::ptrdiff_t>(ends.size()) - 1);
}

}  // namespace

Loaded<TomlNode> parse_toml(const std::string& bytes, const std::string& file) {
  Loaded<TomlNode> out;
  try {
    out.value = plain(toml::parse(std::string_view(bytes)));
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    out.report.error("toml.syntax", file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column),
                     "not TOML here: " + std::string(error.description()),
                     "Texts stand in double quotes, lists in [ ], and every table begins with its name in [ ] or [[ ]]");
  } catch (const TomlTakenForGranted&) {
    out.report.error("toml.syntax", file + ":" + std::to_string(line_of_what_is_broken(bytes)), "not TOML here",
                     "Names of tables and keys are of letters, digits, - and _ or in double quotes; lists stand in [ ]");
  }
  return out;
}

const TomlNode* find(const TomlNode& table, std::string_view key) {
  const auto found = std::find_if(table.items.begin(), table.items.end(), [&](const TomlNode& n) { return n.key == key; });
  return table.kind == TomlKind::table && found != table.items.end() ? &*found : nullptr;
}

std::string in_words(TomlKind kind) {
  switch (kind) {
    case TomlKind::text:
      return "a text";
    case TomlKind::integer:
    case TomlKind::real:
      return "a bare number";
    case TomlKind::boolean:
      return "true or false";
    case TomlKind::array:
      return "a list";
    case TomlKind::table:
      return "a table";
    case TomlKind::date:
      return "a date";
  }
  return "something else";
}

std::string toml_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (c == '\t') {
      out += "\\t";
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      constexpr char digits[] = "0123456789ABCDEF";
      out += "\\u00";
      out += digits[static_cast<unsigned char>(c) >> 4];
      out += digits[static_cast<unsigned char>(c) & 15];
    } else {
      out += c;
    }
  }
  return out + '"';
}

std::string toml_place(const std::string& file, const TomlNode& node) {
  return node.line > 0 ? file + ":" + std::to_string(node.line) : file;
}

void refuse_unknown_keys(const TomlNode& table, std::initializer_list<std::string_view> known, const std::string& file,
                         const std::string& code, Report& report) {
  for (const TomlNode& entry : table.items) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    std::string names;
    for (const std::string_view name : known) names += (names.empty() ? "" : ", ") + std::string(name);
    report.error(code, toml_place(file, entry), "there is no key '" + entry.key + "' here", "The keys are: " + names);
  }
}

}  // namespace toile
