#pragma once
// Values of a seams sidecar: each with its unit, each complaint with its line.

#include <optional>
#include <string>
#include <vector>

#include "formats/toml/toml.h"
#include "garment/pattern.h"

namespace toile {

// The sidecar being read: its name for places, and what there is to say about it.
struct Sidecar {
  std::string file;
  Report report;

  std::string at(const TomlNode& node) const { return toml_place(file, node); }
};

// Each gives nothing after an error "seams.bad-value" when `node` is of another kind or its text has no (right) unit.
std::optional<double> length_of(const TomlNode& node, Sidecar& sidecar);  // m, from "1.5 cm"
std::optional<double> angle_of(const TomlNode& node, Sidecar& sidecar);   // radians, from "22.5 deg" or "0.5 rad"
std::optional<bool> truth_of(const TomlNode& node, Sidecar& sidecar);
std::optional<int> count_of(const TomlNode& node, Sidecar& sidecar);  // 0 .. 1000
std::optional<std::string> text_of(const TomlNode& node, Sidecar& sidecar);
std::optional<std::vector<std::string>> texts_of(const TomlNode& node, Sidecar& sidecar);

// The piece or edge of this name, else the only one that has it in another case; nothing otherwise.
const Piece* piece_by_name(const Pattern& pattern, const std::string& name);
const Edge* edge_by_name(const Piece& piece, const std::string& name);

// "GORE (8 copies), WAISTBAND"; "hem, right, top, left"
std::string piece_names(const Pattern& pattern);
std::string edge_names(const Piece& piece);

}  // namespace toile
