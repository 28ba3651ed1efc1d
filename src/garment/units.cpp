#include "garment/units.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace toile {
namespace {

std::string_view skip_blanks(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::optional<double> take_number(std::string_view& text) {
  text = skip_blanks(text);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

}  // namespace

std::optional<double> parse_length(std::string_view text) {
  auto number = take_number(text);
  if (!number) return std::nullopt;
  if (!text.empty() && text.front() == '/') {
    text.remove_prefix(1);
    const auto below = take_number(text);
    if (!below || *below <= 0) return std::nullopt;
    *number /= *below;
  }
  const std::string_view unit = skip_blanks(text);
  if (unit == "m") return *number;
  if (unit == "cm") return *number * 1e-2;
  if (unit == "mm") return *number * 1e-3;
  if (unit == "in" || unit == "inch" || unit == "\"") return *number * 0.0254;
  if (unit.empty() && *number == 0) return 0.0;
  return std::nullopt;
}

std::string in_mm(double metres, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f mm", digits, metres * mm_per_m);
  return text;
}

}  // namespace toile
