#include "formats/garment_template/garment_template.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "formats/formats.h"
#include "formats/toml/toml.h"
#include "garment/units.h"

namespace toile {
namespace {

struct Reading {
  std::string file;
  Report report;

  void bad(const TomlNode& node, const std::string& text, const std::string& remedy) {
    report.error("garment-template.bad-value", toml_place(file, node), text, remedy);
  }
};

std::string text_of(const TomlNode& node, Reading& reading) {
  if (node.kind == TomlKind::text) return node.text;
  reading.bad(node, "'" + node.key + "' must be a text, not " + in_words(node.kind), "Write it in quotes");
  return {};
}

std::string text_at(const TomlNode& table, const char* key, Reading& reading) {
  const TomlNode* node = find(table, key);
  return node ? text_of(*node, reading) : std::string{};
}

bool truth_at(const TomlNode& table, const char* key, Reading& reading) {
  const TomlNode* node = find(table, key);
  if (!node) return false;
  if (node->kind != TomlKind::boolean) reading.bad(*node, "'" + node->key + "' must be true or false", "Write true or false");
  return node->truth;
}

std::vector<std::string> texts_of(const TomlNode& node, Reading& reading) {
  std::vector<std::string> texts;
  if (node.kind != TomlKind::array) {
    reading.bad(node, "'" + node.key + "' must be a list of texts", "Write [\"one\", \"two\"]");
    return texts;
  }
  for (const TomlNode& item : node.items) texts.push_back(text_of(item, reading));
  return texts;
}

// { en = ["sleeve"], de = ["aermel"] } as one list: files do not say their language.
std::vector<std::string> all_languages(const TomlNode& node, Reading& reading) {
  if (node.kind == TomlKind::array) return texts_of(node, reading);
  std::vector<std::string> texts;
  if (node.kind != TomlKind::table) {
    reading.bad(node, "'" + node.key + "' must be a table from languages to lists of words", "Write { en = [\"sleeve\"] }");
    return texts;
  }
  for (const TomlNode& language : node.items) {
    const std::vector<std::string> more = texts_of(language, reading);
    texts.insert(texts.end(), more.begin(), more.end());
  }
  return texts;
}

double degrees_at(const TomlNode& table, const char* key, Reading& reading) {
  const TomlNode* node = find(table, key);
  if (!node) return 0;
  if ((node->kind == TomlKind::integer || node->kind == TomlKind::real) && std::isfinite(node->number))
    return node->number * degree;
  reading.bad(*node, "'" + node->key + "' must be a number of degrees", "Write for example 90");
  return 0;
}

RolePlace place_of(const TomlNode& node, Reading& reading) {
  RolePlace place;
  if (node.kind != TomlKind::table) {
    reading.bad(node, "'on' must be a list of tables",
                "Write on = [{ face = \"front\", part = \"trunk\", level = \"waist\" }]");
    return place;
  }
  refuse_unknown_keys(node, {"face", "part", "level", "drop", "angle", "half", "grain"}, reading.file,
                      "garment-template.unknown-key", reading.report);
  place.face = text_at(node, "face", reading);
  if (const std::string part = text_at(node, "part", reading); !part.empty()) place.at.part = part;
  if (const std::string level = text_at(node, "level", reading); !level.empty()) place.at.level = level;
  if (const TomlNode* drop = find(node, "drop")) {
    const auto metres = parse_length(text_of(*drop, reading));
    if (!metres) reading.bad(*drop, "'drop' must be a length with its unit", "Write for example \"2 cm\"");
    place.at.drop = metres.value_or(0);
  }
  place.at.angle = degrees_at(node, "angle", reading);
  place.half = degrees_at(node, "half", reading);
  place.at.grain_round = text_at(node, "grain", reading) == "round";
  return place;
}

PieceRole role_of(const TomlNode& node, Reading& reading) {
  PieceRole role;
  refuse_unknown_keys(node, {"role", "names", "default", "extra", "open", "on"}, reading.file, "garment-template.unknown-key",
                      reading.report);
  role.role = text_at(node, "role", reading);
  if (role.role.empty()) reading.bad(node, "this [[piece]] has no role", "Give it one: role = \"sleeve\"");
  if (const TomlNode* names = find(node, "names")) role.names = all_languages(*names, reading);
  role.is_default = truth_at(node, "default", reading);
  role.extra = truth_at(node, "extra", reading);
  if (const TomlNode* open = find(node, "open")) role.open = texts_of(*open, reading);
  if (const TomlNode* on = find(node, "on"))
    for (const TomlNode& item : on->items) role.places.push_back(place_of(item, reading));
  return role;
}

Kinship kinship_at(const TomlNode& table, const char* key, Reading& reading) {
  const TomlNode* node = find(table, key);
  if (!node) return Kinship::any;
  const std::string text = text_of(*node, reading);
  if (text == "same") return Kinship::same;
  if (text == "other") return Kinship::other;
  if (text != "any") reading.bad(*node, "'" + node->key + "' must be same, other or any", "Write one of the three");
  return Kinship::any;
}

// "skirt.top": the role and the side.
void side_at(const TomlNode& table, const char* key, const GarmentTemplate& garment, std::string& role, std::string& side,
             Reading& reading) {
  const TomlNode* node = find(table, key);
  if (!node) return reading.bad(table, "this [[seam]] has no '" + std::string(key) + "'", "A seam has a and b");
  const std::string text = text_of(*node, reading);
  const std::size_t dot = text.rfind('.');
  role = text.substr(0, dot);
  side = dot == std::string::npos ? "any" : text.substr(dot + 1);
  if (side != "top" && side != "bottom" && side != "side" && side != "upright" && side != "crotch" && side != "any")
    reading.bad(*node, "'" + side + "' is no side of a piece", "The sides are top, bottom, side, upright, crotch and any");
  if (std::none_of(garment.roles.begin(), garment.roles.end(), [&](const PieceRole& r) { return r.role == role; }))
    reading.report.error("garment-template.unknown-role", toml_place(reading.file, *node),
                         "no [[piece]] has the role '" + role + "'", "Name a role of this file");
}

SeamRule rule_of(const TomlNode& node, const GarmentTemplate& garment, Reading& reading) {
  SeamRule rule;
  refuse_unknown_keys(node, {"name", "a", "b", "face", "hand", "once"}, reading.file, "garment-template.unknown-key",
                      reading.report);
  rule.name = text_at(node, "name", reading);
  side_at(node, "a", garment, rule.role_a, rule.side_a, reading);
  side_at(node, "b", garment, rule.role_b, rule.side_b, reading);
  rule.face = kinship_at(node, "face", reading);
  rule.hand = kinship_at(node, "hand", reading);
  rule.once = truth_at(node, "once", reading);
  return rule;
}

void read_words(const TomlNode& root, std::map<std::string, std::vector<std::string>>& words, Reading& reading) {
  for (const TomlNode& node : root.items) words[node.key] = all_languages(node, reading);
}

}  // namespace

Loaded<GarmentTemplate> read_garment_template(const std::string& bytes, const std::string& file) {
  const auto root = parse_toml(bytes, file);
  if (!root.value) return {std::nullopt, root.report};
  Reading reading{file, {}};
  GarmentTemplate out;
  refuse_unknown_keys(*root.value, {"name", "openings", "piece", "seam"}, file, "garment-template.unknown-key", reading.report);
  out.name = text_at(*root.value, "name", reading);
  if (const TomlNode* openings = find(*root.value, "openings"))
    for (const TomlNode& item : openings->items) {
      if (item.kind != TomlKind::integer || item.number < 0 || item.number > 100)
        reading.bad(*openings, "'openings' must be a list of small numbers", "Write for example [4]");
      else
        out.openings.push_back(static_cast<int>(item.number));
    }
  if (out.openings.empty() && reading.report.ok())
    reading.bad(*root.value, "nothing says how many openings the garment has", "Write for example openings = [4]");
  if (const TomlNode* pieces = find(*root.value, "piece"))
    for (const TomlNode& item : pieces->items) out.roles.push_back(role_of(item, reading));
  if (const TomlNode* seams = find(*root.value, "seam"))
    for (const TomlNode& item : seams->items) out.seams.push_back(rule_of(item, out, reading));
  if (!reading.report.ok()) return {std::nullopt, reading.report};
  return {std::move(out), reading.report};
}

Loaded<std::vector<GarmentTemplate>> read_garment_templates(const std::filesystem::path& folder) {
  Loaded<std::vector<GarmentTemplate>> out;
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) {
    out.report.error("template.missing", folder.string(), "there are no garment templates",
                     "Set TOILE_TEMPLATES to the folder templates/", Fault::missing);
    return out;
  }
  std::vector<GarmentTemplate> garments;
  std::map<std::string, std::vector<std::string>> words;
  for (const auto& file : files) {
    const auto bytes = read_whole_file(file);
    out.report.append(bytes.report);
    if (!bytes.value) continue;
    if (file.filename() == "words.toml") {
      const auto root = parse_toml(*bytes.value, file.filename().string());
      Reading reading{file.filename().string(), root.report};
      if (root.value) read_words(*root.value, words, reading);
      out.report.append(reading.report);
    } else if (auto garment = read_garment_template(*bytes.value, file.filename().string()); garment.value) {
      garments.push_back(std::move(*garment.value));
    } else {
      out.report.append(garment.report);
    }
  }
  for (GarmentTemplate& garment : garments) garment.words = words;
  if (out.report.ok()) out.value = std::move(garments);
  return out;
}

}  // namespace toile
