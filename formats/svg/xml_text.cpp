#include "formats/svg/xml_text.h"

#include <libxml/xmlwriter.h>

#include <charconv>
#include <cmath>
#include <new>
#include <stdexcept>

namespace toile {
namespace {

const xmlChar* as_xml(const char* text) { return reinterpret_cast<const xmlChar*>(text); }

// Length of the well-formed UTF-8 sequence at the start of `text` that XML may hold; 0 when there is none.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF && follows(1) && follows(2)) {
    const unsigned code = (first & 0x0FU) << 12 | (byte(1) & 0x3FU) << 6 | (byte(2) & 0x3FU);
    return code >= 0x800 && (code < 0xD800 || code > 0xDFFF) && code < 0xFFFE ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4 && follows(1) && follows(2) && follows(3)) {
    const unsigned code = (first & 0x07U) << 18 | (byte(1) & 0x3FU) << 12 | (byte(2) & 0x3FU) << 6 | (byte(3) & 0x3FU);
    return code >= 0x10000 && code <= 0x10FFFF ? 4 : 0;
  }
  return 0;
}

}  // namespace

struct XmlText::Writer {
  xmlBufferPtr buffer = xmlBufferCreate();
  xmlTextWriterPtr text = buffer ? xmlNewTextWriterMemory(buffer, 0) : nullptr;
  ~Writer() {
    if (text) xmlFreeTextWriter(text);
    if (buffer) xmlBufferFree(buffer);
  }
  void check(int result) const {
    if (result < 0) throw std::runtime_error("libxml2 could not write the document");
  }
};

XmlText::XmlText() : writer_(std::make_unique<Writer>()) {
  if (!writer_->text) throw std::bad_alloc();
  xmlTextWriterSetIndent(writer_->text, 1);
  xmlTextWriterSetIndentString(writer_->text, as_xml(" "));
  writer_->check(xmlTextWriterStartDocument(writer_->text, "1.0", "UTF-8", nullptr));
}

XmlText::~XmlText() = default;

XmlText& XmlText::open(const char* element) {
  writer_->check(xmlTextWriterStartElement(writer_->text, as_xml(element)));
  return *this;
}

XmlText& XmlText::with(const char* attribute, std::string_view value) {
  writer_->check(xmlTextWriterWriteAttribute(writer_->text, as_xml(attribute), as_xml(printable(value).c_str())));
  return *this;
}

XmlText& XmlText::with(const char* attribute, double value) { return with(attribute, in_digits(value)); }

XmlText& XmlText::text(std::string_view words) {
  writer_->check(xmlTextWriterWriteString(writer_->text, as_xml(printable(words).c_str())));
  return *this;
}

XmlText& XmlText::close() {
  writer_->check(xmlTextWriterEndElement(writer_->text));
  return *this;
}

std::string XmlText::done() {
  writer_->check(xmlTextWriterEndDocument(writer_->text));
  xmlFreeTextWriter(writer_->text);
  writer_->text = nullptr;
  return {reinterpret_cast<const char*>(xmlBufferContent(writer_->buffer)),
          static_cast<std::size_t>(xmlBufferLength(writer_->buffer))};
}

std::string in_digits(double value) {
  if (!std::isfinite(value)) throw std::invalid_argument("svg: a coordinate is not finite");
  char digits[400];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 3).ptr;
  std::string words(digits, end);
  while (words.back() == '0') words.pop_back();
  if (words.back() == '.') words.pop_back();
  return words == "-0" ? "0" : words;
}

std::string printable(std::string_view words) {
  std::string good;
  while (!words.empty()) {
    const std::size_t length = sequence_length(words);
    good += length ? words.substr(0, length) : std::string_view("?");
    words.remove_prefix(length ? length : 1);
  }
  return good;
}

}  // namespace toile
