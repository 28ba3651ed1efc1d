#pragma once
// DXF as text: pairs of lines, a group code and a value. No meaning yet, but every tag knows its line.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "garment/report.h"

namespace toile::dxf {

struct Tag {
  int code = 0;
  std::string value;  // without surrounding blanks
  int line = 0;       // of the group code, counted from 1
};

// The tags of an ASCII DXF. Takes codes padded or not, LF, CRLF or CR, blank lines at the end; drops 999 comments. Errors:
// "dxf.binary", "dxf.not-dxf" (the first line is no group code), "dxf.broken-tag" (a later one is not), "dxf.truncated" (a code
// without its value). `name` is what findings call the file.
Loaded<std::vector<Tag>> read_tags(std::string_view bytes, const std::string& name);

// Whether a file without the extension is one, binary or not.
bool looks_like_dxf(std::string_view bytes);

// The value as a finite number that may be a coordinate (|x| <= 1e9); leading '+' allowed, decimal comma not.
std::optional<double> number(std::string_view value);
std::optional<int> whole_number(std::string_view value);

std::string_view trimmed(std::string_view text);
bool same_word(std::string_view a, std::string_view b);  // ASCII letters compared without case

}  // namespace toile::dxf
