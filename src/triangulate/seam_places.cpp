#include "triangulate/seam_places.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "garment/units.h"

namespace toile {
namespace {

// Ends of spans this near on one edge are meant to be the same place.
constexpr double same_place = 0.5e-3;  // m

std::string span_in_words(const EdgeSpan& span) { return span.piece + ":" + std::to_string(span.copy) + " " + span.edge; }

template <class Items, class Name>
std::string listed(const Items& items, const Name& name) {
  std::string list;
  for (const auto& item : items) list += (list.empty() ? "'" : ", '") + name(item) + "'";
  return list.empty() ? "none" : list;
}

SpanPlace place_of(const Pattern& pattern, const Seam& seam, const EdgeSpan& span) {
  const Piece* piece = find_piece(pattern, span.piece);
  if (!piece)
    refuse_seam("seam.unknown-piece", seam, "there is no piece '" + span.piece + "'",
                "The pattern has " + listed(pattern.pieces, [](const Piece& p) { return p.name; }));
  const Edge* edge = find_edge(*piece, span.edge);
  if (!edge)
    refuse_seam("seam.unknown-edge", seam, "piece '" + span.piece + "' has no edge '" + span.edge + "'",
                "Its edges are " + listed(piece->outline, [](const Edge& e) { return e.id; }));
  if (span.copy < 1 || span.copy > copies(*piece))
    refuse_seam("seam.unknown-copy", seam, "piece '" + span.piece + "' has no copy " + std::to_string(span.copy),
                "It is cut " + std::to_string(copies(*piece)) + " times; copies count from 1");
  const auto on_edge = [](double at) { return at >= -1e-9 && at <= 1 + 1e-9; };  // false for NaN
  if (!on_edge(span.begin) || !on_edge(span.end))
    refuse_seam("seam.span-outside-edge", seam,
                "the span on edge '" + span.edge + "' of piece '" + span.piece + "' leaves the edge",
                "Give fractions of its length from 0 to 1");
  return {static_cast<int>(piece - pattern.pieces.data()), span.copy, static_cast<int>(edge - piece->outline.data()),
          std::clamp(span.begin, 0.0, 1.0), std::clamp(span.end, 0.0, 1.0)};
}

// Makes ends that nearly agree agree, edge by edge (all copies of a piece share its outline).
void snap_ends(const Pattern& pattern, std::vector<SeamPlace>& seams) {
  std::map<std::pair<int, int>, std::vector<double*>> by_edge;
  for (SeamPlace& seam : seams)
    for (SpanPlace* span : {&seam.a, &seam.b})
      for (double* end : {&span->begin, &span->end}) by_edge[{span->piece, span->edge}].push_back(end);
  for (auto& [key, ends] : by_edge) {
    const Edge& edge = pattern.pieces[static_cast<std::size_t>(key.first)].outline[static_cast<std::size_t>(key.second)];
    const double near = std::min(same_place / length(edge), .25);
    std::sort(ends.begin(), ends.end(), [](const double* x, const double* y) { return *x < *y; });
    double chosen = 0;
    for (double* end : ends) {
      if (*end - chosen > near) chosen = *end;
      *end = 1 - *end <= near ? 1 : chosen;
    }
  }
}

bool overlap(const SpanPlace& one, const SpanPlace& other) {
  return std::tie(one.piece, one.copy, one.edge) == std::tie(other.piece, other.copy, other.edge) &&
         std::max(std::min(one.begin, one.end), std::min(other.begin, other.end)) <
             std::min(std::max(one.begin, one.end), std::max(other.begin, other.end));
}

// Several pieces may be sewn into one seam, but two stretches to each other only once.
void check_spans(const Pattern& pattern, const std::vector<SeamPlace>& seams) {
  const auto refuse = [&](std::size_t s, const SpanPlace& span, const std::string& by, const char* remedy) {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(span.piece)];
    refuse_seam("seam.overlap", pattern.seams[s],
                "edge '" + piece.outline[static_cast<std::size_t>(span.edge)].id + "' of piece '" + piece.name + "', copy " +
                    std::to_string(span.copy) + ", is " + by,
                remedy);
  };
  for (std::size_t s = 0; s < seams.size(); ++s) {
    for (const SpanPlace* span : {&seams[s].a, &seams[s].b})
      if (span->begin == span->end)
        refuse_seam("seam.span-too-short", pattern.seams[s], "one of its spans is shorter than " + in_mm(same_place),
                    "Give it the part of the edge that is sewn");
    if (overlap(seams[s].a, seams[s].b)) refuse(s, seams[s].a, "sewn to itself there", "Let the two spans meet end to end");
  }
  std::map<std::tuple<int, int, int>, std::vector<std::size_t>> on_edge;
  for (std::size_t s = 0; s < seams.size(); ++s)
    for (const SpanPlace* span : {&seams[s].a, &seams[s].b}) {
      auto& others = on_edge[{span->piece, span->copy, span->edge}];
      for (const std::size_t other : others) {
        const SeamPlace &x = seams[other], &y = seams[s];
        if (other == s || !((overlap(x.a, y.a) && overlap(x.b, y.b)) || (overlap(x.a, y.b) && overlap(x.b, y.a)))) continue;
        refuse(s, *span, "already sewn to the other edge there by " + seam_in_words(pattern.seams[other]),
               "Take one of the two seams away, or let their spans meet end to end");
      }
      others.push_back(s);
    }
}

}  // namespace

std::string seam_in_words(const Seam& seam) {
  return (seam.name.empty() ? "seam (" : "seam '" + seam.name + "' (") + span_in_words(seam.a) + " to " +
         span_in_words(seam.b) + ")";
}

void refuse_seam(const char* code, const Seam& seam, std::string text, std::string remedy) {
  throw BadInput({code, Severity::error, seam_in_words(seam), std::move(text), std::move(remedy), Fault::bad_input});
}

std::vector<SeamPlace> seam_places(const Pattern& pattern) {
  std::vector<SeamPlace> seams;
  seams.reserve(pattern.seams.size());
  for (const Seam& seam : pattern.seams) seams.push_back({place_of(pattern, seam, seam.a), place_of(pattern, seam, seam.b)});
  snap_ends(pattern, seams);
  check_spans(pattern, seams);
  return seams;
}

}  // namespace toile
