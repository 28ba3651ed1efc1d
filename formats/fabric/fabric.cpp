// Fabric data, templates/fabrics/NAME.toml; the README there has the keys.

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "formats/formats.h"
#include "formats/toml/toml.h"

namespace toile {
namespace {

struct Unit {
  const char* name;
  double si;
};

// 1 gf = 9.80665e-3 N. Bending stiffness in gf cm^2/cm is what a Kawabata (KES-FB2) tester prints, uN m what FAST-2 prints;
// stretch in gf/cm is a Kawabata tension.
constexpr std::array<Unit, 5> per_area = {
    {{"kg/m^2", 1}, {"kg/m2", 1}, {"g/m^2", 1e-3}, {"g/m2", 1e-3}, {"oz/yd^2", 0.0339057475}}};
constexpr std::array<Unit, 4> force_per_length = {{{"N/m", 1}, {"kN/m", 1e3}, {"N/cm", 1e2}, {"gf/cm", 0.980665}}};
constexpr std::array<Unit, 5> bending = {
    {{"N m", 1}, {"mN m", 1e-3}, {"uN m", 1e-6}, {"\u00b5N m", 1e-6}, {"gf cm^2/cm", 9.80665e-5}}};
constexpr std::array<Unit, 3> lengths = {{{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}}};
constexpr std::array<Unit, 1> shares = {{{"%", 1e-2}}};

struct Quantity {
  const char* key;
  double Fabric::*field;
  const Unit* units;
  std::size_t unit_count;  // 0: a bare number
  double low, high;        // SI; outside is not a clothing fabric
  const char* example;
};

template <std::size_t N>
constexpr Quantity quantity(const char* key, double Fabric::*field, const std::array<Unit, N>& units, double low, double high,
                            const char* example) {
  return {key, field, units.data(), N, low, high, example};
}

constexpr std::array quantities = {
    quantity("area_density", &Fabric::area_density, per_area, .01, 2, "115 g/m^2"),
    quantity("stretch_warp", &Fabric::stretch_warp, force_per_length, 1, 1e6, "1200 N/m"),
    quantity("stretch_weft", &Fabric::stretch_weft, force_per_length, 1, 1e6, "800 N/m"),
    quantity("stretch_cross", &Fabric::stretch_cross, force_per_length, 0, 1e6, "100 N/m"),
    quantity("shear", &Fabric::shear, force_per_length, .1, 1e6, "50 N/m"),
    quantity("bend_warp", &Fabric::bend_warp, bending, 1e-8, 1e-2, "9 uN m"),
    quantity("bend_weft", &Fabric::bend_weft, bending, 1e-8, 1e-2, "6 uN m"),
    Quantity{"friction", &Fabric::friction, nullptr, 0, 0, 2, "0.4"},
    quantity("thickness", &Fabric::thickness, lengths, 2e-5, 2e-2, "0.3 mm"),
    quantity("most_stretch", &Fabric::most_stretch, shares, .005, 2, "8 %"),
};

std::string in_quotes(std::string_view key) {
  std::string out = "'";
  out += key;
  return out += '\'';
}

std::string unit_names(const Quantity& q) {
  std::string names;
  for (std::size_t i = 0; i < q.unit_count; ++i) names += (i ? ", " : "") + std::string(q.units[i].name);
  return names;
}

// Blanks and middle dots between the letters of a unit do not matter: "N m", "N·m", "Nm".
std::string plain_unit(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ' ' || text[i] == '*') continue;
    if (text.substr(i).starts_with("\u00b7")) {
      ++i;
      continue;
    }
    if (text.substr(i).starts_with("\u00b2")) {
      out += "^2";
      ++i;
      continue;
    }
    out += text[i];
  }
  return out;
}

std::optional<double> in_si(const TomlNode& node, const Quantity& q) {
  if (q.unit_count == 0)
    return node.kind == TomlKind::integer || node.kind == TomlKind::real ? std::optional(node.number) : std::nullopt;
  if (node.kind != TomlKind::text) return std::nullopt;
  double number = 0;
  const char* last = node.text.data() + node.text.size();
  const auto [end, error] = std::from_chars(node.text.data(), last, number);
  if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
  const std::string unit = plain_unit({end, static_cast<std::size_t>(last - end)});
  for (std::size_t i = 0; i < q.unit_count; ++i)
    if (unit == plain_unit(q.units[i].name)) return number * q.units[i].si;
  return std::nullopt;
}

void read_quantity(const TomlNode& root, const Quantity& q, const std::string& file, Fabric& fabric, Report& report) {
  const TomlNode* node = find(root, q.key);
  if (!node) {
    report.error("fabric.missing", file, "there is no " + in_quotes(q.key),
                 "Add for example " + std::string(q.key) + " = " + (q.unit_count ? toml_quoted(q.example) : q.example));
    return;
  }
  const auto value = in_si(*node, q);
  if (!value) {
    const std::string got = node->kind == TomlKind::text ? toml_quoted(node->text) : in_words(node->kind);
    report.error(
        "fabric.bad-value", toml_place(file, *node),
        in_quotes(q.key) + " must be " + (q.unit_count ? "a text of a number and its unit" : "a bare number") + ", not " + got,
        q.unit_count ? "Write for example \"" + std::string(q.example) + "\"; the units are " + unit_names(q)
                     : "Write for example " + std::string(q.example));
    return;
  }
  if (!(*value >= q.low && *value <= q.high)) {
    report.error("fabric.out-of-range", toml_place(file, *node),
                 "'" + std::string(q.key) +
                     "' is far from that of any clothing fabric: " + (node->text.empty() ? "the number given" : node->text),
                 "Check the unit; a usual value is " + std::string(q.example));
    return;
  }
  fabric.*q.field = *value;
}

}  // namespace

Loaded<Fabric> read_fabric(const std::filesystem::path& path) {
  Loaded<Fabric> out;
  const auto bytes = read_whole_file(path);
  out.report = bytes.report;
  if (!bytes.value) return out;
  const std::string file = path.filename().string();
  const auto root = parse_toml(*bytes.value, file);
  out.report.append(root.report);
  if (!root.value) return out;
  refuse_unknown_keys(*root.value,
                      {"name", "source", "area_density", "stretch_warp", "stretch_weft", "stretch_cross", "shear", "bend_warp",
                       "bend_weft", "friction", "thickness", "most_stretch"},
                      file, "fabric.unknown-key", out.report);
  Fabric fabric;
  fabric.name = path.stem().string();
  for (const auto& [key, into] : {std::pair{"name", &fabric.name}, std::pair{"source", &fabric.source}}) {
    const TomlNode* node = find(*root.value, key);
    if (node && node->kind != TomlKind::text)
      out.report.error("fabric.bad-value", toml_place(file, *node), in_quotes(key) + " must be a text",
                       "Write it in double quotes");
    else if (node)
      *into = node->text;
  }
  for (const Quantity& q : quantities) read_quantity(*root.value, q, file, fabric, out.report);
  if (out.report.ok() && fabric.stretch_cross * fabric.stretch_cross >= fabric.stretch_warp * fabric.stretch_weft)
    out.report.error(
        "fabric.unstable", toml_place(file, *find(*root.value, "stretch_cross")),
        "'stretch_cross' must be smaller than the geometric mean of 'stretch_warp' and 'stretch_weft', or the cloth "
        "gives way when it is pulled",
        "A tenth to a third of the smaller one is usual");
  if (out.report.ok()) out.value = fabric;
  return out;
}

}  // namespace toile
