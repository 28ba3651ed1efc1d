#include "formats/seams/values.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "garment/units.h"

namespace toile {
namespace {

void wrong_kind(const TomlNode& node, const std::string& wanted, const std::string& example, Sidecar& sidecar) {
  const std::string key = node.key.empty() ? std::string("a value") : "'" + node.key + "'";
  const std::string got = node.kind == TomlKind::text ? toml_quoted(node.text) : in_words(node.kind);
  sidecar.report.error("seams.bad-value", sidecar.at(node), key + " must be " + wanted + ", not " + got, "Write " + example);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// Pointer to the one element that answers to `name`, by `name_of`.
template <class Items, class NameOf>
auto by_name(const Items& items, const std::string& name, NameOf name_of) -> decltype(&items.front()) {
  decltype(&items.front()) alike = nullptr;
  int count = 0;
  for (const auto& item : items) {
    if (name_of(item) == name) return &item;
    if (lower(name_of(item)) == lower(name)) {
      alike = &item;
      ++count;
    }
  }
  return count == 1 ? alike : nullptr;
}

}  // namespace

std::optional<double> length_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::text)
    if (const auto metres = parse_length(node.text)) return metres;
  wrong_kind(node, "a length with its unit", "for example \"4 cm\", \"10 mm\", \"3/8 in\"", sidecar);
  return std::nullopt;
}

std::optional<double> angle_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::text) {
    const std::string& text = node.text;
    const char* begin = text.data() + text.find_first_not_of(" +");
    double number = 0;
    const auto [end, error] = std::from_chars(std::min(begin, text.data() + text.size()), text.data() + text.size(), number);
    std::string unit(end, text.data() + text.size());
    unit.erase(0, unit.find_first_not_of(' '));
    if (error == std::errc{} && std::isfinite(number)) {
      if (unit == "deg" || unit == "degrees" || unit == "\u00b0") return number * units::degree;
      if (unit == "rad") return number;
    }
  }
  wrong_kind(node, "an angle with its unit", "for example \"22.5 deg\" (0 = centre front, 90 deg = the wearer's left)",
             sidecar);
  return std::nullopt;
}

std::optional<bool> truth_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::boolean) return node.truth;
  wrong_kind(node, "true or false", "true or false, without quotes", sidecar);
  return std::nullopt;
}

std::optional<int> count_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::integer && node.number >= 0 && node.number <= 1000) return static_cast<int>(node.number);
  wrong_kind(node, "a whole number from 0 to 1000", "for example 2", sidecar);
  return std::nullopt;
}

std::optional<std::string> text_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::text) return node.text;
  wrong_kind(node, "a text", "it in double quotes", sidecar);
  return std::nullopt;
}

std::optional<std::vector<std::string>> texts_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::text) return std::vector<std::string>{node.text};
  std::vector<std::string> texts;
  const bool all = node.kind == TomlKind::array && std::all_of(node.items.begin(), node.items.end(), [&](const TomlNode& item) {
                     texts.push_back(item.text);
                     return item.kind == TomlKind::text;
                   });
  if (all) return texts;
  wrong_kind(node, "a list of texts", "for example [\"hem\", \"side\"]", sidecar);
  return std::nullopt;
}

const Piece* piece_by_name(const Pattern& pattern, const std::string& name) {
  return pattern.pieces.empty() ? nullptr : by_name(pattern.pieces, name, [](const Piece& p) { return p.name; });
}

const Edge* edge_by_name(const Piece& piece, const std::string& name) {
  return piece.outline.empty() ? nullptr : by_name(piece.outline, name, [](const Edge& e) { return e.id; });
}

std::string piece_names(const Pattern& pattern) {
  std::string names;
  for (const Piece& piece : pattern.pieces) {
    names += (names.empty() ? "" : ", ") + piece.name;
    if (copies(piece) != 1) names += " (" + std::to_string(copies(piece)) + " copies)";
  }
  return names.empty() ? "none" : names;
}

std::string edge_names(const Piece& piece) {
  std::string names;
  for (const Edge& edge : piece.outline) names += (names.empty() ? "" : ", ") + edge.id;
  return names;
}

}  // namespace toile
