#include "formats/svg_read/element.h"

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <algorithm>
#include <climits>
#include <memory>

namespace toile::svg {
namespace {

constexpr std::size_t largest_file = 64u << 20;

std::string text_of(const xmlChar* text) { return text ? reinterpret_cast<const char*>(text) : ""; }

// Attribute and element names as written, whether or not their prefix is declared.
std::string full_name(const xmlNs* ns, const xmlChar* name) {
  return ns && ns->prefix ? text_of(ns->prefix) + ":" + text_of(name) : text_of(name);
}

std::string local_name(const xmlChar* name) {
  const std::string full = text_of(name);
  const std::size_t colon = full.rfind(':');
  return colon == std::string::npos ? full : full.substr(colon + 1);
}

struct Copying {
  int entities = 0;
  int entity_line = 0;
};

std::string value_of(const xmlAttr* attribute, Copying& copying) {
  std::string value;
  for (const xmlNode* part = attribute->children; part; part = part->next) {
    if (part->type == XML_TEXT_NODE)
      value += text_of(part->content);
    else if (part->type == XML_ENTITY_REF_NODE && ++copying.entities == 1)
      copying.entity_line = static_cast<int>(xmlGetLineNo(attribute->parent));
  }
  return value;
}

// The parser has bounded the depth.
Element copied(const xmlNode* node, Copying& copying) {
  Element element;
  element.name = local_name(node->name);
  element.line = static_cast<int>(xmlGetLineNo(node));
  for (const xmlAttr* attribute = node->properties; attribute; attribute = attribute->next)
    element.attributes[full_name(attribute->ns, attribute->name)] = value_of(attribute, copying);
  for (const xmlNode* child = node->children; child; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) {
      element.children.push_back(copied(child, copying));
    } else if (child->type == XML_TEXT_NODE || child->type == XML_CDATA_SECTION_NODE) {
      Element text;
      text.name = "#text";
      text.text = text_of(child->content);
      text.line = element.line;
      element.children.push_back(std::move(text));
    } else if (child->type == XML_ENTITY_REF_NODE && ++copying.entities == 1) {
      copying.entity_line = element.line;
    }
  }
  return element;
}

void report_broken(const xmlError* error, const std::string& name, Report& report) {
  std::string message = error && error->message ? error->message : "unknown";
  while (!message.empty() && (message.back() == '\n' || message.back() == ' ')) message.pop_back();
  const std::string place = name + ":" + std::to_string(error ? error->line : 1);
  if (message.find("depth") != std::string::npos)
    report.error("svg.too-deep", place, "elements are nested deeper than 256", "ungroup the drawing");
  else
    report.error("svg.not-well-formed", place, "the file is no well-formed XML: " + message,
                 "export it again, or open it in a drawing program and save it as plain SVG");
}

}  // namespace

const std::string& Element::get(const std::string& attribute) const {
  static const std::string none;
  const auto found = attributes.find(attribute);
  return found == attributes.end() ? none : found->second;
}

Loaded<Element> read_elements(std::string_view bytes, const std::string& name) {
  Loaded<Element> loaded;
  std::string unpacked;
  if (is_gzip(bytes)) {
    Loaded<std::string> plain = unzipped(bytes, name, largest_file);
    if (!plain.value) return {std::nullopt, std::move(plain.report)};
    unpacked = std::move(*plain.value);
    bytes = unpacked;
  }
  if (bytes.size() > largest_file) {
    loaded.report.error("svg.too-large", name, "the file is larger than 64 MB", "take pictures out of it, or split it");
    return loaded;
  }
  const std::unique_ptr<xmlParserCtxt, void (*)(xmlParserCtxt*)> context(xmlNewParserCtxt(), xmlFreeParserCtxt);
  const std::unique_ptr<xmlDoc, void (*)(xmlDoc*)> document(
      xmlCtxtReadMemory(context.get(), bytes.data(), static_cast<int>(bytes.size()), nullptr, nullptr,
                        XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_BIG_LINES),
      xmlFreeDoc);
  const xmlNode* root = document ? xmlDocGetRootElement(document.get()) : nullptr;
  if (!root) {
    report_broken(xmlCtxtGetLastError(context.get()), name, loaded.report);
    return loaded;
  }
  if (local_name(root->name) != "svg") {
    loaded.report.error("svg.no-svg", name + ":" + std::to_string(xmlGetLineNo(root)),
                        "the file is XML but no SVG: its root is <" + local_name(root->name) + ">",
                        "give an SVG drawing (.svg, .svgz)");
    return loaded;
  }
  Copying copying;
  loaded.value = copied(root, copying);
  if (copying.entities > 0)
    loaded.report.warn("svg.entity", name + ":" + std::to_string(copying.entity_line),
                       std::to_string(copying.entities) + " entities of the file's own are not expanded",
                       "save it as plain SVG when names or values are missing");
  return loaded;
}

std::string words_of(const Element& element) {
  std::string words;
  const auto add = [&](const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool no_break = text.compare(i, 2, "\xc2\xa0") == 0;
      if (no_break) ++i;
      const bool blank = no_break || text[i] == ' ' || text[i] == '\t' || text[i] == '\n' || text[i] == '\r';
      if (!blank)
        words += text[i];
      else if (!words.empty() && words.back() != ' ')
        words += ' ';
    }
  };
  if (element.name == "#text") add(element.text);
  for (const Element& child : element.children)
    if (child.name == "#text" || (child.name != "title" && child.name != "desc" && child.name != "style")) add(words_of(child));
  while (!words.empty() && words.back() == ' ') words.pop_back();
  return words;
}

bool is_definition(const Element& element) {
  constexpr std::string_view names[] = {"defs",           "symbol", "clipPath",  "mask",     "pattern", "marker",
                                        "style",          "title",  "desc",      "metadata", "script",  "linearGradient",
                                        "radialGradient", "filter", "namedview", "font"};
  return std::find(std::begin(names), std::end(names), element.name) != std::end(names);
}

}  // namespace toile::svg
