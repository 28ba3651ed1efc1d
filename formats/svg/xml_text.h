#pragma once
// An XML document written from the top down, escaped by libxml2.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <string_view>

namespace toile {

class XmlText {
 public:
  XmlText();
  ~XmlText();
  XmlText(const XmlText&) = delete;
  XmlText& operator=(const XmlText&) = delete;

  XmlText& open(const char* element);
  XmlText& with(const char* attribute, std::string_view value);
  XmlText& with(const char* attribute, double value);  // at most three digits after the point
  XmlText& text(std::string_view words);
  XmlText& close();
  std::string done();  // closes what is open

 private:
  struct Writer;
  std::unique_ptr<Writer> writer_;
};

// At most three digits after the point, no trailing zeros, no "-0"; throws std::invalid_argument when not finite.
std::string in_digits(double value);

// UTF-8 with whatever XML cannot hold (control characters, broken sequences) replaced by "?".
std::string printable(std::string_view words);

}  // namespace toile
