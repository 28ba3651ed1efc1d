#pragma once
// The "key: value" texts of a style and of a piece.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/dxf/drawing.h"

namespace toile::aama {

struct StyleTexts {
  std::string style;        // "Style Name"
  std::string sample_size;  // empty when absent or NONE
  std::string units;        // "METRIC", "ENGLISH", ...
  std::string product;      // "PRODUCT" (AAMA) or the second field of "Author" (ASTM)
  std::string author;       // "Author", with "PRODUCT" and "VERSION" of AAMA: "vendor ; product ; version"
  std::string rule_table;   // "Grade Rule Table"
  bool says_astm = false;   // a text that only ASTM has
  bool says_aama = false;   // likewise
  int units_line = 0;
  std::vector<std::string> dates;   // "Creation Date" and "Creation Time", whole
  std::vector<std::string> others;  // texts without a known key, whole
};

struct PieceTexts {
  std::string name;  // "Piece Name"; empty when there is none
  std::string size;
  std::string material;         // "Material" or "Fabric"
  std::optional<int> quantity;  // right, as drawn
  std::optional<int> mirrored;  // left
  bool quantity_unreadable = false;
  std::string quantity_text;
  std::vector<std::string> annotations;  // "Annotation", and whole any other text of the boundary layer and plotted text
};

// "Piece Name: front" -> {"piece name", "front"}; no colon: empty key, the whole text as value. Keys in lower case, blanks
// trimmed.
struct KeyValue {
  std::string key, value;
};
KeyValue key_value(std::string_view text);

StyleTexts style_texts(const std::vector<dxf::Entity>& entities);
// Whether piece_texts takes it: on the boundary layer or plotted text (15).
bool is_piece_text(const dxf::Entity& entity);
PieceTexts piece_texts(const std::vector<dxf::Entity>& entities);

// A grade rule text "# 12"; nothing otherwise.
std::optional<int> grade_rule(std::string_view text);

}  // namespace toile::aama
