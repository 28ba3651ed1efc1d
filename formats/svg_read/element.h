#pragma once
// An SVG file as plain elements, read by libxml2 without network, external entities or unlimited depth.

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "garment/report.h"

namespace toile::svg {

struct Element {
  std::string name;  // without prefix; "#text" for text, which is then in `text`
  std::string text;
  std::map<std::string, std::string> attributes;  // with prefix where there is one: "inkscape:label"
  std::vector<Element> children;
  int line = 0;

  const std::string& get(const std::string& attribute) const;  // empty when absent
  bool has(const std::string& attribute) const { return attributes.count(attribute) > 0; }
};

// The root element of `bytes` (plain or gzip). Errors: "svg.too-large" (64 MB unpacked), "svg.broken-gzip",
// "svg.not-well-formed", "svg.too-deep", "svg.no-svg". Entities of the file's own are not expanded in text: "svg.entity".
Loaded<Element> read_elements(std::string_view bytes, const std::string& name);

// Draws nothing where it stands: <defs>, <clipPath>, <metadata>, ...
bool is_definition(const Element& element);

bool is_gzip(std::string_view bytes);
// `bytes` unpacked, at most `limit` of them; error "svg.broken-gzip" or "svg.too-large".
Loaded<std::string> unzipped(std::string_view bytes, const std::string& name, std::size_t limit);

// All text below `element`, blanks and line ends folded into one blank each.
std::string words_of(const Element& element);

}  // namespace toile::svg
