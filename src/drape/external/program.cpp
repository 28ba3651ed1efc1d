#include "drape/external/program.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string_view>

#include "garment/report.h"
#include "garment/templates.h"
#include "garment/tomlplusplus.inc"
#include "garment/units.h"

namespace toile::external {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& place, const std::string& text, const std::string& remedy) {
  throw BadInput({"simulator.external-template", Severity::error, place, text, remedy});
}

std::string at_line(const fs::path& file, const toml::node& node) {
  return file.string() + ":" + std::to_string(node.source().begin.line);
}

// The keys of one table, each of its kind.
class Table {
 public:
  Table(const toml::table& table, fs::path file, std::initializer_list<std::string_view> known)
      : table_(table), file_(std::move(file)) {
    for (const auto& [key, node] : table) {
      if (std::find(known.begin(), known.end(), key.str()) != known.end()) continue;
      std::string list;
      for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
      refuse(at_line(file_, node), "unknown key '" + std::string(key.str()) + "'", "Keys are: " + list);
    }
  }

  std::string text(const char* key, const std::string& otherwise) const {
    const toml::node* node = table_.get(key);
    if (!node) return otherwise;
    if (const auto value = node->value_exact<std::string>()) return *value;
    refuse(at_line(file_, *node), std::string("'") + key + "' is not a text", "Put it in quotes");
  }

  std::string text(const char* key) const {
    if (!table_.get(key)) missing(key, "\"...\"");
    return text(key, "");
  }

  double seconds(const char* key) const {
    const toml::node* node = table_.get(key);
    if (!node) missing(key, "a number of seconds");
    const auto value = node->value<double>();
    if (!value || !(*value > 0))
      refuse(at_line(file_, *node), std::string("'") + key + "' is not above zero", "Give seconds, such as 600");
    return *value;
  }

  double length(const char* key, double otherwise) const {
    if (!table_.get(key)) return otherwise;
    const auto value = parse_length(text(key));
    if (!value || *value < 0)
      refuse(at_line(file_, *table_.get(key)), std::string("'") + key + "' is not a length", "Write \"1 mm\"");
    return *value;
  }

  template <class T, std::size_t N>
  T one_of(const char* key, const std::array<std::pair<const char*, T>, N>& choices, T otherwise) const {
    if (!table_.get(key)) return otherwise;
    const std::string word = text(key);
    std::string list;
    for (const auto& [name, value] : choices) {
      if (word == name) return value;
      list += (list.empty() ? "" : ", ") + std::string(name);
    }
    refuse(at_line(file_, *table_.get(key)), std::string("'") + key + "' cannot be '" + word + "'", "One of: " + list);
  }

  [[noreturn]] void missing(const char* key, const std::string& example) const {
    refuse(file_.string(), std::string("there is no '") + key + "'", std::string("Add ") + key + " = " + example);
  }

 private:
  const toml::table& table_;
  fs::path file_;
};

constexpr std::array<std::pair<const char*, double>, 3> units{{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}}};
constexpr std::array<std::pair<const char*, bool>, 2> ups{{{"y", false}, {"z", true}}};
constexpr std::array<std::pair<const char*, ResultVertices>, 2> vertices{
    {{"garment", ResultVertices::garment}, {"panels", ResultVertices::panels}}};
constexpr std::array<std::pair<const char*, AtRest>, 3> rests{
    {{"program", AtRest::by_program}, {"movement", AtRest::by_movement}, {"residual", AtRest::by_residual}}};

std::string plain_name(const Table& table, const char* key, const std::string& otherwise, const fs::path& file) {
  const std::string name = table.text(key, otherwise);
  if (name.empty() || fs::path(name).filename() != name || name == "." || name == "..")
    refuse(file.string(), std::string("'") + key + "' is '" + name + "'",
           "A file name without folders: it is in the exchange folder");
  return name;
}

void read_lists(const toml::table& root, Program& out) {
  const toml::array* command = root["command"].as_array();
  if (!command || command->empty())
    refuse(out.file.string(), "there is no list 'command'", R"(Add command = ["{program}", "{folder}"])");
  for (const toml::node& word : *command) {
    if (!word.is_string()) refuse(at_line(out.file, word), "a word of 'command' is not a text", "Put it in quotes");
    out.command.push_back(*word.value<std::string>());
  }
  if (const toml::node* files = root.get("file")) {
    if (!files->is_array_of_tables()) refuse(at_line(out.file, *files), "'file' is not a list of tables", "Write [[file]]");
    for (const toml::node& node : *files->as_array()) {
      const Table table(*node.as_table(), out.file, {"from", "to"});
      out.files.push_back({out.file.parent_path() / table.text("from"), plain_name(table, "to", "", out.file)});
    }
  }
  if (const toml::node* values = root.get("values")) {
    if (!values->is_table()) refuse(at_line(out.file, *values), "'values' is not a table", "Write [values]");
    for (const auto& [key, node] : *values->as_table()) {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      if (const auto word = node.value_exact<std::string>())
        text << *word;
      else if (node.is_integer() || node.is_floating_point())
        text << toml::node_view<const toml::node>(&node);
      else
        refuse(at_line(out.file, node), "'" + std::string(key.str()) + "' is neither a number nor a text", "Write a number");
      out.values[std::string(key.str())] = text.str();
    }
  }
}

std::string json_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) out += c;
  }
  return out;
}

}  // namespace

fs::path program_folder() { return template_folder("simulators"); }

std::vector<std::string> program_names() {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(program_folder(), error))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Program read_program(const fs::path& file) {
  toml::table root;
  try {
    root = toml::parse_file(file.string());
  } catch (const toml::parse_error& error) {
    refuse(file.string() + ":" + std::to_string(error.source().begin.line), std::string(error.description()),
           "See the README of templates/simulators");
  } catch (const TomlTakenForGranted&) {
    refuse(file.string(), "not TOML", "See the README of templates/simulators");
  }
  const Table table(root, file, {"name",    "summary",   "program",    "variable", "install", "command", "units",
                                 "up",      "clearance", "time_limit", "most_gap", "garment", "result",  "result_vertices",
                                 "at_rest", "before",    "between",    "still",    "file",    "values"});
  Program out;
  out.file = file;
  out.name = table.text("name");
  out.summary = table.text("summary");
  out.program = table.text("program");
  out.variable = table.text("variable", "");
  out.install = table.text("install", "Install it, or correct 'program' in " + file.string());
  out.unit = table.one_of("units", units, 1.);
  out.z_up = table.one_of("up", ups, false);
  out.clearance = table.length("clearance", 0);
  out.time_limit = table.seconds("time_limit");
  out.most_gap = table.length("most_gap", out.most_gap);
  out.garment = plain_name(table, "garment", out.garment, file);
  out.result = plain_name(table, "result", out.result, file);
  out.result_vertices = table.one_of("result_vertices", vertices, out.result_vertices);
  out.at_rest = table.one_of("at_rest", rests, out.at_rest);
  if (out.at_rest == AtRest::by_movement) {
    if (!root.get("before")) table.missing("before", "the name of a result from shortly before the last");
    if (!root.get("still")) table.missing("still", "\"1 mm\"");
    out.before = plain_name(table, "before", "", file);
    out.between = table.seconds("between");
    out.still = table.length("still", 0);
  }
  read_lists(root, out);
  return out;
}

std::string filled(const std::string& text, const std::string& open, const std::string& close,
                   const std::map<std::string, std::string>& values, const std::string& place, Escape escape) {
  const auto is_name = [](const std::string& word) {
    return !word.empty() && word.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
  };
  std::string out;
  std::size_t at = 0;
  for (std::size_t next = text.find(open); next != std::string::npos; next = text.find(open, at)) {
    const std::size_t end = text.find(close, next + open.size());
    const std::string name = end == std::string::npos ? "" : text.substr(next + open.size(), end - next - open.size());
    if (!is_name(name)) {  // a brace that is only a brace
      out += text.substr(at, next + 1 - at);
      at = next + 1;
      continue;
    }
    const auto found = values.find(name);
    if (found == values.end()) {
      std::string list;
      for (const auto& [known, value] : values) list += (list.empty() ? "" : ", ") + known;
      refuse(place, "nothing is called '" + open + name + close + "'", "Use one of: " + list + "; or add it to [values]");
    }
    out += text.substr(at, next - at) + (escape == Escape::json ? json_escaped(found->second) : found->second);
    at = end + close.size();
  }
  return out + text.substr(at);
}

}  // namespace toile::external
