#include "formats/garmentcode/garmentcode.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>

#include "formats/formats.h"
#include "formats/garmentcode/panel.h"
#include "garment/units.h"

namespace toile {
namespace {

using Json = nlohmann::json;

std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::size_t end = std::min(byte == 0 ? 0 : byte - 1, text.size());
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
  const std::size_t newline = end == 0 ? std::string::npos : text.rfind('\n', end - 1);
  const std::size_t column = newline == std::string::npos ? end + 1 : end - newline;
  return std::to_string(line) + ":" + std::to_string(column);
}

std::optional<Json> parse(const std::string& text, const std::string& file, Report& report) {
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    report.error("json.syntax", file + ":" + line_and_column(text, error.byte),
                 "not JSON from here on (byte " + std::to_string(error.byte) + ")",
                 "The file may be cut off or edited by hand; export it again");
  } catch (const Json::exception& error) {
    report.error("json.syntax", file, "not readable as JSON: " + std::string(error.what()), "Export it again");
  }
  return std::nullopt;
}

const Json* inside(const Json* node, const char* key) {
  if (!node || !node->is_object()) return nullptr;
  const auto found = node->find(key);
  return found == node->end() ? nullptr : &*found;
}

std::optional<GarmentCodeUnits> read_units(const Json& root, std::optional<double> unit_in_metres, const std::string& file,
                                           Report& report) {
  GarmentCodeUnits units;
  const Json* properties = inside(&root, "properties");
  const Json* per_metre = inside(properties, "units_in_meter");
  const bool said = per_metre && per_metre->is_number() && per_metre->get<double>() > 0;
  if (!said && !unit_in_metres) {
    report.error("garmentcode.units", file, "properties.units_in_meter does not say how many units make a metre",
                 "Add it: 100 for a pattern drawn in centimetres; or say --units cm", Fault::ambiguous);
    return std::nullopt;
  }
  units.metres = unit_in_metres ? *unit_in_metres : 1 / per_metre->get<double>();
  const Json* curves = inside(properties, "curvature_coords");
  if (curves && *curves == "absolute") {
    units.relative_curves = false;
  } else if (curves && *curves != "relative") {
    report.error("garmentcode.bad-value", file, "properties.curvature_coords is neither \"relative\" nor \"absolute\"",
                 "Write one of the two");
    return std::nullopt;
  }
  return units;
}

// What is in the file and not in the value.
void say_unknown_keys(const Json& root, const Json& spec, const std::string& file, Report& report) {
  std::set<std::string> unknown;
  const auto look = [&](const Json& node, const std::string& where, std::initializer_list<const char*> known) {
    if (!node.is_object()) return;
    for (const auto& member : node.items())
      if (std::find(known.begin(), known.end(), member.key()) == known.end()) unknown.insert(where + member.key());
  };
  look(root, "", {"pattern", "properties", "parameters", "parameter_order", "constraints", "constraint_order"});
  look(spec, "pattern.", {"panels", "stitches", "panel_order"});
  if (const Json* properties = inside(&root, "properties"))
    look(*properties, "properties.",
         {"units_in_meter", "curvature_coords", "normalize_panel_translation", "normalized_edge_loops"});
  for (const Json& panel : *inside(&spec, "panels")) {
    look(panel, "panel.", {"vertices", "edges", "translation", "rotation", "label"});
    if (const Json* edges = inside(&panel, "edges"))
      for (const Json& edge : *edges) look(edge, "edge.", {"endpoints", "curvature", "label"});
  }
  std::string names;
  for (const std::string& key : unknown) names += (names.empty() ? "" : ", ") + key;
  if (!names.empty()) report.note("garmentcode.unknown-keys", file, "left aside, because nothing is known of it: " + names);
}

// The file's own order where it gives one; what that leaves out follows by name.
std::vector<std::string> panel_names(const Json& pattern, const Json& panels) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (panels.contains(name) && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (const Json* order = inside(&pattern, "panel_order"); order && order->is_array())
    for (const Json& name : *order)
      if (name.is_string()) add(name.get<std::string>());
  for (const auto& panel : panels.items()) add(panel.key());
  return names;
}

std::optional<EdgeSpan> side_of(const Json& side, const Pattern& pattern, const std::string& place, Report& report) {
  const Json* panel = inside(&side, "panel");
  const Json* edge = inside(&side, "edge");
  if (!panel || !edge || !panel->is_string() || !edge->is_number_integer()) {
    report.error("garmentcode.bad-stitch", place, "a side of a stitch must name a panel and an edge number",
                 "Write for example {\"panel\": \"front\", \"edge\": 0}");
    return std::nullopt;
  }
  const Piece* piece = find_piece(pattern, panel->get<std::string>());
  if (!piece) {
    std::string names;
    for (const Piece& p : pattern.pieces) names += (names.empty() ? "" : ", ") + p.name;
    report.error("seam.unknown-piece", place, "there is no panel '" + panel->get<std::string>() + "'",
                 "The panels are " + names);
    return std::nullopt;
  }
  const auto k = edge->get<std::int64_t>();
  if (k < 0 || k >= static_cast<std::int64_t>(piece->outline.size())) {
    report.error("seam.unknown-edge", place, "panel '" + piece->name + "' has no edge " + std::to_string(k),
                 "Its edges are 0 to " + std::to_string(piece->outline.size() - 1));
    return std::nullopt;
  }
  return EdgeSpan{piece->name, 1, piece->outline[static_cast<std::size_t>(k)].id, 0, 1};
}

void read_stitches(const Json& stitches, Pattern& pattern, const std::string& file, Report& report) {
  if (!stitches.is_array()) {
    report.error("garmentcode.bad-stitch", file, "'stitches' must be a list", "Write [] for a pattern without stitches");
    return;
  }
  for (std::size_t i = 0; i < stitches.size(); ++i) {
    const Json& stitch = stitches[i];
    const std::string place = file + ", stitch " + std::to_string(i);
    const bool right_wrong = stitch.is_array() && stitch.size() == 3 && stitch[2] == "right_wrong";
    if (!stitch.is_array() || (stitch.size() != 2 && !right_wrong)) {
      report.error("garmentcode.bad-stitch", place,
                   "a stitch must be a pair of sides, with \"right_wrong\" after them or nothing",
                   "Write for example [{\"panel\": \"front\", \"edge\": 0}, {\"panel\": \"back\", \"edge\": 3}]");
      continue;
    }
    const auto a = side_of(stitch[0], pattern, place, report);
    auto b = side_of(stitch[1], pattern, place, report);
    if (!a || !b) continue;
    if (a->piece == b->piece && a->edge == b->edge) {
      report.error("garmentcode.bad-stitch", place, "edge '" + a->edge + "' of panel '" + a->piece + "' is sewn to itself",
                   "Split the edge in two");
      continue;
    }
    if (!right_wrong) std::swap(b->begin, b->end);
    pattern.seams.push_back({a->piece + "." + a->edge + " to " + b->piece + "." + b->edge, *a, *b, right_wrong});
  }
}

std::string name_of(const std::filesystem::path& file) {
  std::string name = file.stem().string();
  constexpr std::string_view suffix = "_specification";
  if (name.ends_with(suffix) && name.size() > suffix.size()) name.resize(name.size() - suffix.size());
  return name;
}

FileUnits units_of(const GarmentCodeUnits& units, bool overridden) {
  const char* name = "";
  for (const auto& [known, metres] :
       {std::pair("m", 1.), std::pair("cm", 1e-2), std::pair("mm", 1e-3), std::pair("inch", .0254)})
    if (std::abs(units.metres / metres - 1) < 1e-9) name = known;
  return {name, units.metres, overridden ? "override" : "format"};
}

}  // namespace

Loaded<PatternFile> read_garmentcode_text(const std::string& text, const std::filesystem::path& path,
                                          std::optional<double> unit_in_metres) {
  Loaded<PatternFile> out;
  const std::string file = path.filename().string();
  const auto root = parse(text, file, out.report);
  if (!root) return out;
  const Json* spec = inside(&*root, "pattern");
  const Json* panels = inside(spec, "panels");
  if (!panels || !panels->is_object() || panels->empty()) {
    out.report.error("garmentcode.missing", file, "there is no pattern.panels", "Give a GarmentCode pattern specification");
    return out;
  }
  const auto units = read_units(*root, unit_in_metres, file, out.report);
  if (!units) return out;
  PatternFile made;
  made.format = "GarmentCode";
  made.units = units_of(*units, unit_in_metres.has_value());
  Pattern& pattern = made.pattern;
  pattern.name = name_of(path);
  for (const std::string& name : panel_names(*spec, *panels))
    if (auto piece = read_panel((*panels)[name], name, *units, file, out.report)) pattern.pieces.push_back(std::move(*piece));
  if (!out.report.ok()) return out;
  const Json* stitches = inside(spec, "stitches");
  if (stitches)
    read_stitches(*stitches, pattern, file, out.report);
  else
    out.report.warn("garmentcode.no-stitches", file, "there is no pattern.stitches: nothing is sewn",
                    "Export the whole pattern, or write what is sewn to what to a seams file beside it");
  if (!out.report.ok()) return out;
  say_unknown_keys(*root, *spec, file, out.report);
  out.report.note("garmentcode.grain", file,
                  "the format knows no grain line; the grain is taken along the y axis of each panel");
  for (const Piece& piece : pattern.pieces) made.facts.push_back({piece.name, true, "panel", false, 0});
  out.value = std::move(made);
  return out;
}

Loaded<PatternFile> read_garmentcode_file(const std::filesystem::path& file, std::optional<double> unit_in_metres) {
  const auto bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, bytes.report};
  return read_garmentcode_text(*bytes.value, file, unit_in_metres);
}

Loaded<Pattern> read_garmentcode(const std::string& text, const std::filesystem::path& file) {
  Loaded<PatternFile> read = read_garmentcode_text(text, file);
  if (!read.value) return {std::nullopt, std::move(read.report)};
  return {std::move(read.value->pattern), std::move(read.report)};
}

Loaded<Pattern> read_garmentcode(const std::filesystem::path& file) {
  const auto bytes = read_whole_file(file);
  if (!bytes.value) return {std::nullopt, bytes.report};
  return read_garmentcode(*bytes.value, file);
}

}  // namespace toile
