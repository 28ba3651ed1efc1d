#include "cli/recipe_file.h"

#include <algorithm>
#include <sstream>

#include "formats/formats.h"
#include "formats/pdf/write_pdf.h"
#include "formats/toml/toml.h"
#include "garment/tomlplusplus.inc"
#include "garment/units.h"

namespace toile {
namespace {

// One table of the recipe: takes its keys one by one, then refuses what is left.
class Section {
 public:
  Section(const toml::table& table, std::string name, std::string file)
      : table_(table), name_(std::move(name)), file_(std::move(file)) {}

  std::string place(const toml::node* node = nullptr) const {
    const toml::source_position at = (node ? node->source() : table_.source()).begin;
    return file_ + ":" + std::to_string(at.line);
  }

  [[noreturn]] void fail(const toml::node* node, std::string code, std::string text, std::string remedy) const {
    throw BadInput({std::move(code), Severity::error, place(node), std::move(text), std::move(remedy)});
  }

  const toml::node* find(const std::string& key) {
    known_.push_back(key);
    return table_.get(key);
  }

  std::optional<std::string> text(const std::string& key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (const auto value = node->value_exact<std::string>()) return *value;
    fail(node, "recipe.not-text", "'" + label(key) + "' is not text", "Write it in quotes: " + key + " = \"...\"");
  }

  std::string needed_text(const std::string& key, const std::string& example) {
    if (auto value = text(key)) return *value;
    fail(nullptr, "recipe.missing-key", "'" + label(key) + "' is missing", "Add: " + key + " = \"" + example + "\"");
  }

  void length(const std::string& key, double& into, double least) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto written = node->value_exact<std::string>();
    const auto metres = written ? parse_length(*written) : std::nullopt;
    if (!metres)
      fail(node, "recipe.no-unit", "'" + label(key) + "' is not a length with its unit",
           "Write for example " + key + " = \"1 cm\"");
    if (*metres < least)
      fail(node, "recipe.out-of-range", "'" + label(key) + "' is too small", "Give at least " + in_mm(least));
    into = *metres;
  }

  void number(const std::string& key, double& into, double least, double most) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto value = node->value<double>();
    if (!value || !(*value >= least && *value <= most))
      fail(node, "recipe.out-of-range", "'" + label(key) + "' is not a number in its range",
           "Give a number from " + plain(least) + " to " + plain(most));
    into = *value;
  }

  void whole_number(const std::string& key, int& into, int least, int most) {
    const toml::node* node = find(key);
    if (!node) return;
    const auto value = node->value_exact<int64_t>();
    if (!value || *value < least || *value > most)
      fail(node, "recipe.out-of-range", "'" + label(key) + "' is not a whole number in its range",
           "Give a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    into = static_cast<int>(*value);
  }

  void refuse_unknown() const {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
      std::string keys;
      for (const std::string& known : known_) keys += (keys.empty() ? "" : ", ") + known;
      fail(&node, "recipe.unknown-key", "'" + label(name) + "' means nothing here", "Known here: " + keys);
    }
  }

 private:
  std::string label(const std::string& key) const { return name_.empty() ? key : name_ + "." + key; }
  static std::string plain(double value) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%g", value);
    return digits;
  }

  const toml::table& table_;
  std::string name_, file_;
  std::vector<std::string> known_;
};

// How an edit's argument is written does not matter to TOML's types; operations read text.
std::string argument_text(const toml::node& node, const Section& section, const std::string& key) {
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto list = node.as_array()) {
    std::string joined;
    for (const auto& item : *list) {
      const auto text = item.value_exact<std::string>();
      if (!text)
        section.fail(&node, "recipe.not-text", "the list '" + key + "' holds something that is not text", "Quote its entries");
      joined += (joined.empty() ? "" : ",") + *text;
    }
    return joined;
  }
  if (const auto number = node.value<double>()) {
    char digits[64];
    std::snprintf(digits, sizeof digits, "%.17g", *number);
    return digits;
  }
  section.fail(&node, "recipe.not-text", "'" + key + "' is neither text, a number nor a list of texts", "Write it in quotes");
}

// A name of templates/fabrics, or a file.
FabricName fabric_named(const std::string& text, const std::filesystem::path& folder) {
  if (std::filesystem::path(text).has_extension()) return {{}, folder / text};
  return {text, {}};
}

Recipe parse(const toml::table& root, const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  const std::string name = file.string();
  static const toml::table nothing;
  Recipe recipe;
  Section top(root, "", name);
  recipe.name = top.text("name").value_or(file.stem().string());
  const auto section = [&](const std::string& key, bool needed) {
    const toml::node* node = top.find(key);
    if (!node && needed)
      top.fail(nullptr, "recipe.missing-key", "the part [" + key + "] is missing", "Add [" + key + "] to the recipe");
    if (node && !node->is_table())
      top.fail(node, "recipe.not-a-table", "'" + key + "' is not a part of the recipe", "Write [" + key + "]");
    return Section(node ? *node->as_table() : nothing, key, name);
  };

  Section pattern = section("pattern", true);
  recipe.pattern.file = folder / pattern.needed_text("file", "skirt.dxf");
  if (const auto seams = pattern.text("seams")) recipe.pattern.seams = folder / *seams;
  if (const auto units = pattern.text("units")) {
    recipe.pattern.unit_in_metres = parse_length("1" + *units);
    if (!recipe.pattern.unit_in_metres)
      pattern.fail(pattern.find("units"), "recipe.unknown-unit", "'pattern.units' is '" + *units + "'", "Use mm, cm, m or in");
  }
  pattern.refuse_unknown();

  Section body = section("body", true);
  if (const auto obj = body.text("file")) {
    recipe.body.file = folder / *obj;
    if (const auto skeleton = body.text("skeleton")) recipe.body.skeleton = folder / *skeleton;
  } else {
    recipe.body.chart = body.text("chart").value_or("women");
    recipe.body.size = body.needed_text("size", "38");
  }
  body.refuse_unknown();

  Section fabric = section("fabric", true);
  if (const auto path = fabric.text("file"))
    recipe.fabric.file = folder / *path;
  else
    recipe.fabric.name = fabric.needed_text("name", "jersey");
  fabric.refuse_unknown();

  Section replica = section("replica", false);
  if (replica.find("height")) replica.length("height", recipe.replica.height.emplace(), 10e-3);
  replica.refuse_unknown();

  Section drape = section("drape", false);
  recipe.drape.simulator = drape.text("simulator").value_or(recipe.drape.simulator);
  // "external:NAME" is one of templates/simulators; a file is meant as the recipe's other files are.
  const std::filesystem::path program = recipe.drape.simulator;
  if (program.extension() == ".toml" && recipe.drape.simulator.rfind("external:", 0) != 0)
    recipe.drape.simulator = (folder / program).string();
  drape.length("edge_length", recipe.drape.edge_length, 2e-3);
  drape.number("tolerance", recipe.drape.tolerance, 1e-8, 1e-1);
  drape.refuse_unknown();

  if (const toml::node* edits = top.find("edit")) {
    const toml::array* list = edits->as_array();
    if (!list) top.fail(edits, "recipe.not-a-list", "'edit' is not a list", "Write [[edit]] before each edit");
    for (const auto& item : *list) {
      if (!item.is_table()) top.fail(&item, "recipe.not-a-table", "an edit is not a table", "Write [[edit]] before each edit");
      Section edit(*item.as_table(), "edit", name);
      Edit made{edit.needed_text("operation", "length"), {}, edit.place()};
      for (const auto& [key, node] : *item.as_table()) {
        const std::string argument(key.str());
        if (argument != "operation") made.arguments[argument] = argument_text(node, edit, argument);
      }
      recipe.edits.push_back(std::move(made));
    }
  }

  Section adjusting = section("adjust", false);
  adjusting.whole_number("steps", recipe.adjust.steps, 1, 50);
  adjusting.number("tolerance", recipe.adjust.tolerance, 1e-8, 1e-1);
  if (const auto other = adjusting.text("fabric")) recipe.adjust.fabric = fabric_named(*other, folder);
  if (const toml::node* locked = adjusting.find("locked")) {
    std::istringstream names(argument_text(*locked, adjusting, "locked"));
    for (std::string edge; std::getline(names, edge, ',');) recipe.adjust.locked.push_back(edge);
  }
  adjusting.refuse_unknown();

  Section cut = section("cut", false);
  cut.length("allowance", recipe.cut.allowances.allowance, 0);
  cut.length("hem", recipe.cut.allowances.hem, 0);
  cut.length("width", recipe.cut.width, 0.1);
  cut.length("gap", recipe.cut.gap, 0);
  cut.refuse_unknown();

  Section print = section("print", false);
  recipe.print.paper = print.text("paper").value_or(recipe.print.paper);
  print.length("margin", recipe.print.margin, 0);
  print.length("overlap", recipe.print.overlap, 0);
  if (const auto fault = fault_of(PrintOptions{recipe.print.paper, recipe.print.margin, recipe.print.overlap}))
    print.fail(print.find(fault->place), fault->code, fault->text, fault->remedy);
  print.refuse_unknown();
  top.refuse_unknown();
  return recipe;
}

}  // namespace

Loaded<Recipe> read_recipe_text(const std::string& text, const std::filesystem::path& file) {
  Loaded<Recipe> loaded;
  if (const Loaded<TomlNode> tree = parse_toml(text, file.string()); !tree.value) {
    loaded.report = tree.report;
    for (Finding& finding : loaded.report.findings) finding.code = "recipe.not-toml";
    return loaded;
  }
  try {
    loaded.value = parse(toml::parse(text), file);
  } catch (const BadInput& bad) {
    loaded.report.findings.push_back(bad.finding());
  }
  return loaded;
}

Loaded<Recipe> read_recipe(const std::filesystem::path& file) {
  const Loaded<std::string> text = read_whole_file(file);
  if (!text.value) return {std::nullopt, text.report};
  return read_recipe_text(*text.value, file);
}

}  // namespace toile
