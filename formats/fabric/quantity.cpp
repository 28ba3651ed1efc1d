#include "formats/fabric/quantity.h"

#include <charconv>
#include <cmath>

namespace toile {
namespace {

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

std::optional<double> value_of(const TomlNode& node, const Quantity& q) {
  if (q.unit_count == 0)
    return node.kind == TomlKind::integer || node.kind == TomlKind::real ? std::optional(node.number) : std::nullopt;
  return node.kind == TomlKind::text ? in_si(node.text, q) : std::nullopt;
}

std::string written(const Quantity& q) { return q.unit_count ? toml_quoted(q.example) : q.example; }

}  // namespace

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

std::optional<double> in_si(std::string_view text, const Quantity& q) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  double number = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
  const std::string unit = plain_unit({end, static_cast<std::size_t>(last - end)});
  for (std::size_t i = 0; i < q.unit_count; ++i)
    if (unit == plain_unit(q.units[i].name)) return number * q.units[i].si;
  return std::nullopt;
}

std::optional<double> quantity_in(const TomlNode& node, const Quantity& q, const std::string& file, Report& report) {
  const auto value = value_of(node, q);
  if (!value) {
    const std::string got = node.kind == TomlKind::text ? toml_quoted(node.text) : in_words(node.kind);
    report.error(
        "fabric.bad-value", toml_place(file, node),
        in_quotes(q.key) + " must be " + (q.unit_count ? "a text of a number and its unit" : "a bare number") + ", not " + got,
        "Write for example " + written(q) + (q.unit_count ? "; the units are " + unit_names(q) : ""));
    return std::nullopt;
  }
  if (!(*value >= q.low && *value <= q.high)) {
    report.error(
        "fabric.out-of-range", toml_place(file, node),
        in_quotes(q.key) + " is far from that of any clothing fabric: " + (node.text.empty() ? "the number given" : node.text),
        "Check the unit; a usual value is " + std::string(q.example));
    return std::nullopt;
  }
  return value;
}

void report_missing(const Quantity& q, const std::string& place, const std::string& hint, Report& report) {
  report.error("fabric.missing", place, "there is no " + in_quotes(q.key),
               "Add for example " + std::string(q.key) + " = " + written(q) + hint);
}

}  // namespace toile
