#pragma once
// Pages made from Mustache templates (templates/reports).

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace toile::html {

// What fills a template: a text, a condition, a list, or named slots.
class Slot {
 public:
  enum class type { fields, list, text, condition };

  Slot() = default;
  explicit Slot(type kind) : kind_(kind) {}
  Slot(std::string text) : kind_(type::text), text_(std::move(text)) {}
  Slot(const char* text) : Slot(std::string(text)) {}
  explicit Slot(bool holds) : kind_(type::condition), holds_(holds) {}

  void set(const std::string& name, Slot value);  // of fields
  void push_back(Slot value);                     // of a list

  type kind() const { return kind_; }
  const std::string& text() const { return text_; }
  bool holds() const { return holds_; }
  const std::vector<Slot>& list_value() const { return below_; }
  const std::vector<std::string>& names() const { return names_; }  // one for each of list_value(), of fields

 private:
  type kind_ = type::fields;
  std::string text_;
  bool holds_ = false;
  std::vector<std::string> names_;
  std::vector<Slot> below_;
};

// `page` with its slots filled. Throws BadInput "report.bad-template"; `pattern` is the file to compare it with.
std::string rendered(const Slot& slots, const std::string& page, const std::string& pattern);

// The template in the file `page`, {{> NAME}} in it replaced by the file NAME beside it. Throws BadInput.
std::string read_page(const std::filesystem::path& page);

// Reads the template `page`, and writes what `fill` makes of its text to `file`. Throws BadInput.
void write_page(const std::filesystem::path& file, const std::filesystem::path& page,
                const std::function<std::string(const std::string&)>& fill);

}  // namespace toile::html
