#include "formats/dxf/tags.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace toile::dxf {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Cuts the next line off `rest`; the line end may be LF, CRLF or a lone CR.
std::string_view next_line(std::string_view& rest) {
  const std::size_t end = rest.find_first_of("\r\n");
  const std::string_view line = rest.substr(0, end);
  if (end == std::string_view::npos) {
    rest = {};
  } else {
    const bool pair = rest[end] == '\r' && end + 1 < rest.size() && rest[end + 1] == '\n';
    rest.remove_prefix(end + (pair ? 2 : 1));
  }
  return line;
}

bool is_binary(std::string_view bytes) { return bytes.substr(0, 18) == "AutoCAD Binary DXF"; }

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\v\f");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\v\f") - first + 1);
}

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

std::optional<double> number(std::string_view value) {
  value = trimmed(value);
  if (!value.empty() && value.front() == '+') value.remove_prefix(1);
  double result = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
  if (error != std::errc{} || end != value.data() + value.size()) return {};
  if (!std::isfinite(result) || std::abs(result) > 1e9) return {};
  return result;
}

std::optional<int> whole_number(std::string_view value) {
  value = trimmed(value);
  if (!value.empty() && value.front() == '+') value.remove_prefix(1);
  int result = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), result);
  if (error != std::errc{} || end != value.data() + value.size()) return {};
  return result;
}

bool looks_like_dxf(std::string_view bytes) {
  if (is_binary(bytes)) return true;
  const std::optional<int> code = whole_number(next_line(bytes));
  const std::string_view value = trimmed(next_line(bytes));
  return code == 999 || (code == 0 && value == "SECTION") || (code == 9 && value.substr(0, 1) == "$");
}

Loaded<std::vector<Tag>> read_tags(std::string_view bytes, const std::string& name) {
  Loaded<std::vector<Tag>> loaded;
  if (is_binary(bytes)) {
    loaded.report.error("dxf.binary", name, "this is a binary DXF, which Toile does not read",
                        "save it as ASCII DXF (R12 is the safest)");
    return loaded;
  }
  if (bytes.substr(0, 3) == "\xEF\xBB\xBF") bytes.remove_prefix(3);

  std::vector<Tag> tags;
  tags.reserve(bytes.size() / 12);
  int line = 0;
  while (!bytes.empty()) {
    const std::string_view code_text = trimmed(next_line(bytes));
    const int code_line = ++line;
    const std::optional<int> code = whole_number(code_text);
    if (!code || *code < -5 || *code > 1071) {
      constexpr std::string_view nothing = " \t\r\n\x1a";  // the old end-of-file mark included
      if (code_text.find_first_not_of(nothing) == std::string_view::npos &&
          bytes.find_first_not_of(nothing) == std::string_view::npos)
        break;
      const std::string shown(code_text.substr(0, 40));
      if (tags.empty())
        loaded.report.error("dxf.not-dxf", name,
                            "this is not a DXF file: its first line should be a group code, but is '" + shown + "'",
                            "export the pattern as DXF-AAMA or DXF-ASTM");
      else
        loaded.report.error("dxf.broken-tag", name + ":" + std::to_string(code_line),
                            "a group code should stand here, but it is '" + shown + "'",
                            "the file is damaged or was edited by hand; export it again");
      return loaded;
    }
    if (bytes.empty()) {
      loaded.report.error("dxf.truncated", name + ":" + std::to_string(code_line),
                          "the file ends in the middle of a group (code " + std::to_string(*code) + " without its value)",
                          "the file is cut off; export or copy it again");
      return loaded;
    }
    const std::string_view value = trimmed(next_line(bytes));
    ++line;
    if (*code == 999) continue;
    tags.push_back({*code, std::string(value), code_line});
    if (*code == 0 && same_word(value, "EOF")) break;
  }
  if (tags.empty())
    loaded.report.error("dxf.not-dxf", name, "the file holds no DXF groups", "export the pattern as DXF-AAMA or DXF-ASTM");
  else
    loaded.value = std::move(tags);
  return loaded;
}

}  // namespace toile::dxf
