#include "formats/seams/span.h"

#include <algorithm>

#include "formats/seams/span_text.h"
#include "garment/units.h"

namespace toile {
namespace {

constexpr double past_the_end = 1e-4;  // m, a run given by lengths may exceed its edge by this

std::optional<AlongEdge> along_of(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::integer || node.kind == TomlKind::real) return AlongEdge{node.number, false};
  if (node.kind == TomlKind::text)
    if (const auto along = parse_along(node.text)) return along;
  sidecar.report.error(
      "seam.range", sidecar.at(node), "'" + node.key + "' is no place along an edge",
      "Write a fraction such as \"1/8\", \"0.25\" or \"25 %\", a length such as \"5 cm\", \"start\" or \"end\"");
  return std::nullopt;
}

std::optional<SpanText> span_in_text(const TomlNode& node, Sidecar& sidecar) {
  if (node.kind == TomlKind::text) {
    if (auto span = parse_span(node.text)) return span;
    sidecar.report.error("seam.syntax", sidecar.at(node), "cannot read " + toml_quoted(node.text) + " as a run of an edge",
                         "Write PIECE.EDGE, PIECE:COPY.EDGE or PIECE:COPY.EDGE[FROM..TO], for example "
                         "\"gore:1.right\" or \"waistband.bottom[0..1/8]\"");
    return std::nullopt;
  }
  if (node.kind != TomlKind::table) {
    sidecar.report.error("seam.syntax", sidecar.at(node),
                         "a run of an edge must be a text or a table, not " + in_words(node.kind),
                         "Write for example \"gore:1.right\"");
    return std::nullopt;
  }
  refuse_unknown_keys(node, {"piece", "copy", "edge", "from", "to"}, sidecar.file, "seam.unknown-key", sidecar.report);
  const TomlNode* piece = find(node, "piece");
  const TomlNode* edge = find(node, "edge");
  if (!piece || !edge) {
    sidecar.report.error("seam.syntax", sidecar.at(node), "a run of an edge needs 'piece' and 'edge'",
                         "Write for example { piece = \"gore\", copy = 1, edge = \"right\" }");
    return std::nullopt;
  }
  const auto piece_name = text_of(*piece, sidecar), edge_name = text_of(*edge, sidecar);
  if (!piece_name || !edge_name) return std::nullopt;
  SpanText span;
  span.piece = *piece_name;
  span.edge = *edge_name;
  if (const TomlNode* copy = find(node, "copy")) {
    span.copy = count_of(*copy, sidecar);
    if (!span.copy) return std::nullopt;
  }
  for (const auto& [key, into] : {std::pair{"from", &span.from}, std::pair{"to", &span.to}})
    if (const TomlNode* place = find(node, key)) {
      const auto along = along_of(*place, sidecar);
      if (!along) return std::nullopt;
      *into = *along;
    }
  return span;
}

// As a fraction; a run may overshoot the end by a rounding.
double fraction(const AlongEdge& along, double edge_length) {
  const double at = along.is_length ? along.value / edge_length : along.value;
  const double slack = along.is_length ? past_the_end / edge_length : 1e-9;
  if (at < 0 && at >= -slack) return 0;
  if (at > 1 && at <= 1 + slack) return 1;
  return at;
}

}  // namespace

std::vector<EdgeSpan> spans_of(const TomlNode& node, const Pattern& pattern, bool all_copies, Sidecar& sidecar) {
  const auto text = span_in_text(node, sidecar);
  if (!text) return {};
  const Piece* piece = piece_by_name(pattern, text->piece);
  if (!piece) {
    sidecar.report.error("seam.unknown-piece", sidecar.at(node), "the pattern has no piece '" + text->piece + "'",
                         "Its pieces are " + piece_names(pattern));
    return {};
  }
  const int count = copies(*piece);
  const std::string names = "Piece '" + piece->name + "' has the copies 1 to " + std::to_string(count);
  if (text->copy && (*text->copy < 1 || *text->copy > count)) {
    sidecar.report.error("seam.unknown-copy", sidecar.at(node),
                         "piece '" + piece->name + "' has no copy " + std::to_string(*text->copy), names);
    return {};
  }
  if (!text->copy && count != 1 && !all_copies) {
    sidecar.report.error("seam.unknown-copy", sidecar.at(node),
                         "piece '" + piece->name + "' is cut " + std::to_string(count) + " times, and no copy is named",
                         names + "; write for example \"" + piece->name + ":1." + text->edge + "\"");
    return {};
  }
  const Edge* edge = edge_by_name(*piece, text->edge);
  if (!edge) {
    sidecar.report.error("seam.unknown-edge", sidecar.at(node), "piece '" + piece->name + "' has no edge '" + text->edge + "'",
                         "Its edges are " + edge_names(*piece));
    return {};
  }
  const double from = fraction(text->from, length(*edge)), to = fraction(text->to, length(*edge));
  if (!(from >= 0 && to <= 1 && from < to)) {
    sidecar.report.error(
        "seam.range", sidecar.at(node),
        "the run from " + exact_number(from) + " to " + exact_number(to) + " does not lie on edge '" + edge->id +
            "' of piece '" + piece->name + "', which is " + in_mm(length(*edge)) + " long",
        "Runs go forwards along the outline, from the smaller to the larger place; reversed = true on the seam "
        "joins beginning to beginning");
    return {};
  }
  std::vector<EdgeSpan> spans;
  for (int copy = text->copy.value_or(1); copy <= text->copy.value_or(count); ++copy)
    spans.push_back({piece->name, copy, edge->id, from, to});
  return spans;
}

}  // namespace toile
