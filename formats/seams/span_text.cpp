#include "formats/seams/span_text.h"

#include <array>
#include <charconv>
#include <cmath>

#include "garment/units.h"

namespace toile {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

std::optional<double> whole_number_or_decimal(std::string_view text) {
  text = trimmed(text);
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(number)) return std::nullopt;
  return number;
}

}  // namespace

std::optional<AlongEdge> parse_along(std::string_view text) {
  text = trimmed(text);
  if (text == "start") return AlongEdge{0, false};
  if (text == "end") return AlongEdge{1, false};
  if (!text.empty() && text.back() == '%') {
    const auto percent = whole_number_or_decimal(text.substr(0, text.size() - 1));
    if (!percent) return std::nullopt;
    return AlongEdge{*percent / 100, false};
  }
  if (const auto number = whole_number_or_decimal(text)) return AlongEdge{*number, false};
  if (const auto slash = text.find('/'); slash != std::string_view::npos) {
    const auto above = whole_number_or_decimal(text.substr(0, slash));
    const auto below = whole_number_or_decimal(text.substr(slash + 1));
    if (above && below && *below > 0) return AlongEdge{*above / *below, false};
  }
  if (const auto metres = parse_length(text)) return AlongEdge{*metres, true};
  return std::nullopt;
}

std::optional<SpanText> parse_span(std::string_view text) {
  SpanText span;
  text = trimmed(text);
  if (!text.empty() && text.back() == ']') {
    const auto open = text.rfind('[');
    if (open == std::string_view::npos) return std::nullopt;
    const std::string_view range = text.substr(open + 1, text.size() - open - 2);
    const auto dots = range.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    const auto from = parse_along(range.substr(0, dots));
    const auto to = parse_along(range.substr(dots + 2));
    if (!from || !to) return std::nullopt;
    span.from = *from;
    span.to = *to;
    text = trimmed(text.substr(0, open));
  }
  const auto dot = text.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  span.edge = std::string(trimmed(text.substr(dot + 1)));
  std::string_view piece = text.substr(0, dot);
  if (const auto colon = piece.rfind(':'); colon != std::string_view::npos) {
    const std::string_view digits = trimmed(piece.substr(colon + 1));
    int copy = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), copy);
    if (error == std::errc{} && end == digits.data() + digits.size()) {
      span.copy = copy;
      piece = piece.substr(0, colon);
    }
  }
  span.piece = std::string(trimmed(piece));
  if (span.piece.empty() || span.edge.empty() || span.edge.find_first_of("[]") != std::string::npos) return std::nullopt;
  return span;
}

std::string exact_number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string span_text(const EdgeSpan& span, bool cut_once) {
  std::string text = span.piece;
  if (!cut_once) text += ":" + std::to_string(span.copy);
  text += "." + span.edge;
  if (span.begin != 0 || span.end != 1) text += "[" + exact_number(span.begin) + ".." + exact_number(span.end) + "]";
  return text;
}

}  // namespace toile
