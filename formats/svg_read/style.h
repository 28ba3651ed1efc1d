#pragma once
// How an element is drawn: presentation attributes, style sheets and style attributes, as far as a pattern needs them.

#include <map>
#include <string>
#include <vector>

#include "formats/svg_read/element.h"

namespace toile::svg {

struct Style {
  std::string fill = "black", stroke = "none", dash = "none", visibility = "visible", display = "inline", opacity = "1";
  std::string clip_path = "none", mask = "none";
  std::string marker_start = "none", marker_end = "none";
  std::string font_size = "16", font_weight = "400", text_anchor = "start";

  bool is_shown() const;                                 // the element itself: visibility and opacity
  bool is_removed() const { return display == "none"; }  // with all below it
  bool is_drawn() const;                                 // it has a stroke or a fill
  bool is_dashed() const;
  bool is_clipped() const { return clip_path != "none" || mask != "none"; }  // with all below it
};

class StyleSheet {
 public:
  // All <style> elements below `root`; at-rules, pseudo-classes and attribute selectors are passed over.
  static StyleSheet of(const Element& root);

  // The style of the last of `way` (the root first), given its parent's.
  Style style_of(const std::vector<const Element*>& way, const Style& parent) const;

 private:
  struct Compound {
    std::string tag, id;
    std::vector<std::string> classes;
    bool child = false;  // of the one before it, not only somewhere below
  };
  struct Rule {
    std::vector<Compound> selector;
    int weight = 0;
    std::map<std::string, std::string> properties;
  };
  static bool fits(const Compound& compound, const Element& element);
  static bool fits(const std::vector<Compound>& selector, std::size_t last, const std::vector<const Element*>& way,
                   std::size_t at);
  static std::vector<Compound> selector_of(const std::string& text);  // empty: not understood
  void add(const std::string& text);

  std::vector<Rule> rules_;  // lighter first, of one weight in file order
};

std::vector<std::string> split(const std::string& text, const std::string& separators);

}  // namespace toile::svg
