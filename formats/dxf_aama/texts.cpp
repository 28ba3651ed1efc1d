#include "formats/dxf_aama/texts.h"

#include <algorithm>

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
  std::string author, product, version;
  for (const dxf::Entity& entity : entities) {
    if (entity.kind != dxf::Kind::text) continue;
    auto [key, value] = key_value(entity.text);
    if (key == "style name") {
      texts.style = value;
    } else if (key == "sample size") {
      if (lower(value) != "none") texts.sample_size = value;
    } else if (key == "author") {
      author = value;
    } else if (key == "product") {
      product = value;
    } else if (key == "version") {
      version = value;
    } else if (key == "grade rule table" || key == "grading rule table") {
      texts.rule_table = value;
    } else if (key == "units") {
      texts.units = value;
      texts.units_line = entity.line;
    } else if (key.find("astm") != std::string::npos || key == "curve tolerance") {
      texts.says_astm = true;
    } else if (key.find("aama") != std::string::npos || key == "tolerance") {
      texts.says_aama = true;
    } else if (key == "creation date" || key == "creation time") {
      texts.dates.push_back(entity.text);
    } else if (!entity.text.empty()) {
      texts.others.push_back(entity.text);
    }
  }
  texts.says_astm = texts.says_astm || author.find(';') != std::string::npos;
  texts.says_aama = texts.says_aama || !product.empty() || !version.empty();
  texts.product = product.empty() ? second_field(author) : product;
  texts.author = author;
  for (const std::string& more : {product, version})
    if (!more.empty()) texts.author += (texts.author.empty() ? "" : " ; ") + more;
  return texts;
}

bool is_piece_text(const dxf::Entity& entity) {
  const Role role = role_of(entity.layer);
  return entity.kind == dxf::Kind::text && (role == Role::cut_line || role == Role::plotted_text);
}

PieceTexts piece_texts(const std::vector<dxf::Entity>& entities) {
  PieceTexts texts;
  const auto annotate = [&](const std::string& text) {
    if (!text.empty() && std::find(texts.annotations.begin(), texts.annotations.end(), text) == texts.annotations.end())
      texts.annotations.push_back(text);
  };
  for (const dxf::Entity& entity : entities) {
    if (!is_piece_text(entity) || grade_rule(entity.text)) continue;
    auto [key, value] = key_value(entity.text);
    if (role_of(entity.layer) == Role::plotted_text)
      annotate(entity.text);
    else if (key == "piece name")
      texts.name = value;
    else if (key == "size" || key == "size name")
      texts.size = value;
    else if (key == "quantity")
      read_quantity(texts, value);
    else if (key == "material" || (key == "fabric" && texts.material.empty()))
      texts.material = value;
    else if (key == "annotation")
      annotate(value);
    else
      annotate(entity.text);
  }
  return texts;
}

std::optional<int> grade_rule(std::string_view text) {
  text = dxf::trimmed(text);
  if (text.empty() || text.front() != '#') return {};
  return dxf::whole_number(text.substr(1));
}

}  // namespace toile::aama
