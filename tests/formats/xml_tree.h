#pragma once
// An XML text read back by libxml2, as plain elements.

#include <libxml/parser.h>
#include <libxml/tree.h>

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace toile::test {

struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::vector<Element> children;

  std::string get(const std::string& attribute) const {
    const auto found = attributes.find(attribute);
    return found == attributes.end() ? "" : found->second;
  }
};

inline Element element_of(const xmlNode* node) {
  Element element{reinterpret_cast<const char*>(node->name), {}, {}, {}};
  for (const xmlAttr* a = node->properties; a; a = a->next)
    if (a->children)
      element.attributes[reinterpret_cast<const char*>(a->name)] = reinterpret_cast<const char*>(a->children->content);
  for (const xmlNode* child = node->children; child; child = child->next) {
    if (child->type == XML_ELEMENT_NODE) element.children.push_back(element_of(child));
    if (child->type == XML_TEXT_NODE) element.text += reinterpret_cast<const char*>(child->content);
  }
  return element;
}

inline Element parse_xml(const std::string& text) {
  xmlDoc* document = xmlReadMemory(text.data(), static_cast<int>(text.size()), "test.svg", nullptr,
                                   XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  if (!document) throw std::runtime_error("not well-formed");
  Element root = element_of(xmlDocGetRootElement(document));
  xmlFreeDoc(document);
  return root;
}

// All elements below `root` with this attribute value, in document order.
inline void collect(const Element& root, const std::string& attribute, const std::string& value, std::vector<Element>& found) {
  if (root.get(attribute) == value) found.push_back(root);
  for (const Element& child : root.children) collect(child, attribute, value, found);
}

inline std::vector<Element> all_with(const Element& root, const std::string& attribute, const std::string& value) {
  std::vector<Element> found;
  collect(root, attribute, value, found);
  return found;
}

}  // namespace toile::test
