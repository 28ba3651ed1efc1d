#include <algorithm>

#include "formats/svg_read/drawing.h"

namespace toile::svg {

Names names_of(const Element& element) {
  Names names{element.name, element.get("id"), {}, split(element.get("class"), " \t\r\n"), {}, element.line};
  for (const char* key : {"inkscape:label", "aria-label", "data-name"})
    if (names.label.empty()) names.label = element.get(key);
  for (const Element& child : element.children)
    if (names.label.empty() && child.name == "title" && element.name != "svg")
      for (const Element& text : child.children) names.label += text.text;
  for (const auto& [key, value] : element.attributes)
    if (key.compare(0, 5, "data-") == 0) names.data[key.substr(5)] = value;
  return names;
}

bool Names::has_class(const std::string& name) const {
  return std::find(classes.begin(), classes.end(), name) != classes.end();
}

std::string Names::datum(const std::string& key) const {
  const auto found = data.find(key);
  return found == data.end() ? std::string() : found->second;
}

bool Drawing::within(int group, int ancestor) const {
  for (; group >= 0; group = groups[static_cast<std::size_t>(group)].parent)
    if (group == ancestor) return true;
  return false;
}

}  // namespace toile::svg
