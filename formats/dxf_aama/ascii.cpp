#include "formats/dxf_aama/ascii.h"

#include <cstdint>
#include <optional>

#include "formats/dxf/tags.h"

namespace toile::aama {
namespace {

// U+00C0 .. U+017F
constexpr std::string_view latin[] = {
    "A",  "A", "A",  "A", "Ae", "Aa", "AE", "C", "E",  "E",  "E",  "E", "I",  "I", "I",  "I",  "D",  "N", "O",  "O", "O", "O",
    "Oe", "x", "Oe", "U", "U",  "U",  "Ue", "Y", "Th", "ss", "a",  "a", "a",  "a", "ae", "aa", "ae", "c", "e",  "e", "e", "e",
    "i",  "i", "i",  "i", "d",  "n",  "o",  "o", "o",  "o",  "oe", "_", "oe", "u", "u",  "u",  "ue", "y", "th", "y", "A", "a",
    "A",  "a", "A",  "a", "C",  "c",  "C",  "c", "C",  "c",  "C",  "c", "D",  "d", "D",  "d",  "E",  "e", "E",  "e", "E", "e",
    "E",  "e", "E",  "e", "G",  "g",  "G",  "g", "G",  "g",  "G",  "g", "H",  "h", "H",  "h",  "I",  "i", "I",  "i", "I", "i",
    "I",  "i", "I",  "i", "IJ", "ij", "J",  "j", "K",  "k",  "k",  "L", "l",  "L", "l",  "L",  "l",  "L", "l",  "L", "l", "N",
    "n",  "N", "n",  "N", "n",  "n",  "N",  "n", "O",  "o",  "O",  "o", "O",  "o", "OE", "oe", "R",  "r", "R",  "r", "R", "r",
    "S",  "s", "S",  "s", "S",  "s",  "S",  "s", "T",  "t",  "T",  "t", "T",  "t", "U",  "u",  "U",  "u", "U",  "u", "U", "u",
    "U",  "u", "U",  "u", "W",  "w",  "Y",  "y", "Y",  "Z",  "z",  "Z", "z",  "Z", "z",  "s"};
static_assert(std::size(latin) == 0x180 - 0xC0);

// The code point at the front of `text` and its length; nothing when the bytes are no UTF-8.
std::optional<std::pair<std::uint32_t, std::size_t>> code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
  const std::uint32_t lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >> 5 == 6 ? 2 : lead >> 4 == 14 ? 3 : lead >> 3 == 30 ? 4 : 0;
  if (length == 0 || length > text.size()) return {};
  std::uint32_t value = length == 1 ? lead : lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (byte(i) >> 6 != 2) return {};
    value = (value << 6) | (byte(i) & 0x3F);
  }
  return std::pair{value, length};
}

std::string_view in_ascii(std::uint32_t c) {
  if (c >= 0xC0 && c < 0x180) return latin[c - 0xC0];
  switch (c) {
    case 0xA0:
    case 0x2009:
    case 0x202F:
      return " ";
    case 0x2010:
    case 0x2011:
    case 0x2012:
    case 0x2013:
    case 0x2014:
    case 0x2212:
      return "-";
    case 0x2018:
    case 0x2019:
    case 0xB4:
      return "'";
    case 0x201C:
    case 0x201D:
    case 0x201E:
      return "\"";
    case 0xD7:
      return "x";
    case 0xB0:
      return " deg";
    case 0xB1:
      return "+-";
    case 0x2026:
      return "...";
    default:
      return "_";
  }
}

}  // namespace

std::string ascii(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto decoded = code_point(text);
    const std::uint32_t c = decoded ? decoded->first : static_cast<unsigned char>(text.front());
    if (c < 0x20 || c == 0x7F)
      result += ' ';
    else if (c < 0x7F)
      result += static_cast<char>(c);
    else
      result += in_ascii(c);
    text.remove_prefix(decoded ? decoded->second : 1);
  }
  return std::string(dxf::trimmed(result));
}

std::string block_name(std::string_view text) {
  std::string name;
  for (char c : ascii(text)) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    const bool allowed = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    name += allowed ? c : '_';
  }
  if (name.empty()) name = "PIECE";
  return name.substr(0, 31);
}

}  // namespace toile::aama
