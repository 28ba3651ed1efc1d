#pragma once
// How a run of an edge is written in a seams sidecar: "gore:1.right", "waistband.bottom[0..1/8]", "sleeve.cap[5 cm..end]".

#include <optional>
#include <string>
#include <string_view>

#include "garment/pattern.h"

namespace toile {

// A place along an edge, counted in the direction of the outline.
struct AlongEdge {
  double value = 0;
  bool is_length = false;  // metres from the edge's beginning instead of a fraction of its length
  bool operator==(const AlongEdge&) const = default;
};

struct SpanText {
  std::string piece;
  std::optional<int> copy;
  std::string edge;
  AlongEdge from, to{1, false};
  bool operator==(const SpanText&) const = default;
};

// "0.25", "1/8", "12.5 %", "5 cm", "start", "end"; nothing when it is none of these.
std::optional<AlongEdge> parse_along(std::string_view text);

// PIECE[:COPY].EDGE["[" FROM ".." TO "]"]; nothing when it is not of this form. The last point ends the piece's
// name, and a colon belongs to it unless a whole number follows.
std::optional<SpanText> parse_span(std::string_view text);

// The text for a span whose begin is not after its end; the copy is left out for copy 1 of a piece that is cut once.
std::string span_text(const EdgeSpan& span, bool cut_once);

// The shortest decimal that reads back as the same number.
std::string exact_number(double value);

}  // namespace toile
