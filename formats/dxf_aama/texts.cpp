#include "formats/dxf_aama/texts.h"

#include "formats/dxf/tags.h"
#include "formats/dxf_aama/layers.h"

namespace toile::aama {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return result;
}

// "right,left" (ASTM) or one number (AAMA).
void read_quantity(PieceTexts& texts, const std::string& value) {
  texts.quantity_text = value;
  const std::size_t comma = value.find_first_of(",;");
  const std::optional<int> right = dxf::whole_number(value.substr(0, comma));
  const std::optional<int> left = comma == std::string::npos ? 0 : dxf::whole_number(value.substr(comma + 1));
  texts.quantity_unreadable = !right || !left || *right < 0 || *left < 0 || *right > 10000 || *left > 10000;
  if (texts.quantity_unreadable) return;
  texts.quantity = right;
  texts.mirrored = left;
}

// The second field of "vendor ; product ; version".
std::string second_field(const std::string& text) {
  const std::size_t first = text.find(';');
  if (first == std::string::npos) return {};
  const std::string rest = text.substr(first + 1);
  return std::string(dxf::trimmed(std::string_view(rest).substr(0, rest.find(';'))));
}

}  // namespace

KeyValue key_value(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return {{}, std::string(dxf::trimmed(text))};
  return {lower(dxf::trimmed(text.substr(0, colon))), std::string(dxf::trimmed(text.substr(colon + 1)))};
}

StyleTexts style_texts(const std::vector<dxf::Entity>& entities) {
  StyleTexts texts;
  for (const dxf::Entity& entity : entities) {
    if (entity.kind != dxf::Kind::text) continue;
    auto [key, value] = key_value(entity.text);
    if (key == "style name") texts.style = value;
    if (key == "sample size" && lower(value) != "none") texts.sample_size = value;
    if (key == "product") texts.product = value;
    if (key == "author" && texts.product.empty()) texts.product = second_field(value);
    if (key == "units") {
      texts.units = value;
      texts.units_line = entity.line;
    }
  }
  return texts;
}

PieceTexts piece_texts(const std::vector<dxf::Entity>& entities) {
  PieceTexts texts;
  for (const dxf::Entity& entity : entities) {
    if (entity.kind != dxf::Kind::text || role_of(entity.layer) != Role::cut_line || grade_rule(entity.text)) continue;
    auto [key, value] = key_value(entity.text);
    if (key == "piece name")
      texts.name = value;
    else if (key == "size" || key == "size name")
      texts.size = value;
    else if (key == "quantity")
      read_quantity(texts, value);
    else if (key == "material" || (key == "fabric" && texts.material.empty()))
      texts.material = value;
    else if (key == "annotation") {
      if (!value.empty()) texts.annotations.push_back(value);
    } else if (!entity.text.empty())
      texts.annotations.push_back(entity.text);
  }
  return texts;
}

std::optional<int> grade_rule(std::string_view text) {
  text = dxf::trimmed(text);
  if (text.empty() || text.front() != '#') return {};
  return dxf::whole_number(text.substr(1));
}

}  // namespace toile::aama
