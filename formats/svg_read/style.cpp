#include "formats/svg_read/style.h"

#include <algorithm>
#include <cctype>

#include "formats/svg_read/numbers.h"

namespace toile::svg {
namespace {

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n\f");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n\f") - begin + 1);
}

// "a: b; c: d !important": important ones under "!a".
std::map<std::string, std::string> declarations(const std::string& text) {
  std::map<std::string, std::string> found;
  for (const std::string& one : split(text, ";")) {
    const std::size_t colon = one.find(':');
    if (colon == std::string::npos) continue;
    std::string value = trimmed(one.substr(colon + 1));
    std::string key = trimmed(one.substr(0, colon));
    if (const std::size_t bang = value.find("!important"); bang != std::string::npos) {
      value = trimmed(value.substr(0, bang));
      key = "!" + key;
    }
    found[key] = value;
  }
  return found;
}

void set(Style& style, const Style& parent, const std::string& key, const std::string& value) {
  struct Property {
    const char* name;
    std::string Style::*member;
  };
  static const Property properties[] = {
      {"fill", &Style::fill},
      {"stroke", &Style::stroke},
      {"stroke-dasharray", &Style::dash},
      {"visibility", &Style::visibility},
      {"display", &Style::display},
      {"opacity", &Style::opacity},
      {"clip-path", &Style::clip_path},
      {"mask", &Style::mask},
      {"marker-start", &Style::marker_start},
      {"marker-end", &Style::marker_end},
      {"font-size", &Style::font_size},
      {"font-weight", &Style::font_weight},
      {"text-anchor", &Style::text_anchor},
  };
  if (key == "marker") style.marker_start = style.marker_end = value;
  for (const Property& property : properties)
    if (key == property.name) style.*property.member = value == "inherit" ? parent.*property.member : value;
}

void apply(Style& style, const Style& parent, const std::map<std::string, std::string>& properties, bool important) {
  for (const auto& [key, value] : properties)
    if ((key[0] == '!') == important) set(style, parent, important ? key.substr(1) : key, value);
}

std::string without_comments(const std::string& text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size();) {
    if (text.compare(i, 2, "/*") == 0) {
      const std::size_t end = text.find("*/", i + 2);
      i = end == std::string::npos ? text.size() : end + 2;
    } else {
      clean += text[i++];
    }
  }
  return clean;
}

void collect_styles(const Element& element, std::string& text) {
  if (element.name == "style")
    for (const Element& child : element.children) text += child.text + "\n";
  for (const Element& child : element.children) collect_styles(child, text);
}

}  // namespace

std::vector<std::string> split(const std::string& text, const std::string& separators) {
  std::vector<std::string> parts;
  for (std::size_t begin = text.find_first_not_of(separators); begin != std::string::npos;) {
    const std::size_t end = text.find_first_of(separators, begin);
    parts.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return parts;
}

bool Style::is_shown() const {
  const std::optional<Length> seen = length_of(opacity);
  return visibility != "hidden" && visibility != "collapse" && !(seen && seen->value <= 0);
}

bool Style::is_drawn() const {
  const auto paints = [](const std::string& paint) { return paint != "none" && paint != "transparent"; };
  return paints(fill) || paints(stroke);
}

bool Style::is_dashed() const {
  const std::vector<double> lengths = numbers_in(dash);
  return std::any_of(lengths.begin(), lengths.end(), [](double length) { return length > 0; });
}

StyleSheet StyleSheet::of(const Element& root) {
  std::string text;
  collect_styles(root, text);
  StyleSheet sheet;
  sheet.add(without_comments(text));
  std::stable_sort(sheet.rules_.begin(), sheet.rules_.end(), [](const Rule& a, const Rule& b) { return a.weight < b.weight; });
  return sheet;
}

void StyleSheet::add(const std::string& text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const std::size_t open = text.find('{', at);
    if (open == std::string::npos) return;
    std::string head = trimmed(text.substr(at, open - at));
    if (const std::size_t statement = head.rfind(';'); statement != std::string::npos)
      head = trimmed(head.substr(statement + 1));
    std::size_t close = open + 1;
    for (int depth = 1; close < text.size() && (depth += text[close] == '{' ? 1 : text[close] == '}' ? -1 : 0) > 0;) ++close;
    const std::string body = text.substr(open + 1, close - open - 1);
    at = close + 1;
    if (head.empty() || head[0] == '@') continue;
    const auto properties = declarations(body);
    for (const std::string& one : split(head, ",")) {
      Rule rule{selector_of(trimmed(one)), 0, properties};
      if (rule.selector.empty()) continue;
      for (const Compound& compound : rule.selector)
        rule.weight +=
            (compound.id.empty() ? 0 : 10000) + 100 * static_cast<int>(compound.classes.size()) + !compound.tag.empty();
      rules_.push_back(std::move(rule));
    }
  }
}

std::vector<StyleSheet::Compound> StyleSheet::selector_of(const std::string& text) {
  std::vector<Compound> selector;
  bool child = false;
  std::string spaced;
  for (const char c : text) spaced += c == '>' ? std::string(" > ") : std::string(1, c);
  for (const std::string& word : split(spaced, " \t\r\n\f")) {
    if (word == ">") {
      child = true;
      continue;
    }
    if (word.find_first_of("[:+~") != std::string::npos) return {};
    Compound compound;
    compound.child = child;
    child = false;
    for (std::size_t i = 0; i < word.size();) {
      const std::size_t end = std::min(word.find_first_of(".#", i + 1), word.size());
      const std::string name = word.substr(i, end - i);
      if (name[0] == '.')
        compound.classes.push_back(name.substr(1));
      else if (name[0] == '#')
        compound.id = name.substr(1);
      else if (name != "*")
        compound.tag = name.substr(name.find('|') == std::string::npos ? 0 : name.find('|') + 1);
      i = end;
    }
    selector.push_back(std::move(compound));
  }
  return selector;
}

bool StyleSheet::fits(const Compound& compound, const Element& element) {
  if (!compound.tag.empty() && compound.tag != element.name) return false;
  if (!compound.id.empty() && compound.id != element.get("id")) return false;
  if (compound.classes.empty()) return true;
  const std::vector<std::string> classes = split(element.get("class"), " \t\r\n");
  return std::all_of(compound.classes.begin(), compound.classes.end(),
                     [&](const std::string& name) { return std::find(classes.begin(), classes.end(), name) != classes.end(); });
}

// Whether selector[0..last] describes way[at]; the nearest ancestor that fits is taken for each compound.
bool StyleSheet::fits(const std::vector<Compound>& selector, std::size_t last, const std::vector<const Element*>& way,
                      std::size_t at) {
  if (!fits(selector[last], *way[at])) return false;
  while (last > 0) {
    const bool child = selector[last].child;
    --last;
    do {
      if (at == 0) return false;
      --at;
    } while (!child && !fits(selector[last], *way[at]));
    if (!fits(selector[last], *way[at])) return false;
  }
  return true;
}

Style StyleSheet::style_of(const std::vector<const Element*>& way, const Style& parent) const {
  const Element& element = *way.back();
  Style style = parent;
  style.display = "inline";
  style.opacity = "1";
  style.clip_path = style.mask = "none";
  for (const auto& [key, value] : element.attributes) set(style, parent, key, value);
  const auto own = declarations(element.get("style"));
  for (const bool important : {false, true}) {
    for (const Rule& rule : rules_)
      if (fits(rule.selector, rule.selector.size() - 1, way, way.size() - 1)) apply(style, parent, rule.properties, important);
    apply(style, parent, own, important);
  }
  return style;
}

}  // namespace toile::svg
