#include "edit/mix/take_part.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "edit/mix/even_chords.h"
#include "edit/mix/limb_curve.h"
#include "edit/mix/marks.h"
#include "garment/welds.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr double least_edge = 1e-6;    // m
constexpr double least_bend = 0.3e-3;  // m, of a curve point from the end of a cut edge

// What became of part of an edge.
struct KeptEdge {
  int piece = 0;  // of the part
  std::string id;
  double begin = 0, end = 1;  // of the whole edge
};

struct CutEdge {
  int piece = 0;
  std::string id;
  bool along = true;  // runs as the chord does
};

// One side of a piece, being drawn.
struct Drawing {
  Piece piece;
  std::vector<std::pair<int, KeptEdge>> kept;  // by edge of the whole piece
  std::vector<std::pair<std::size_t, CutEdge>> cut;
};

std::string free_id(const Piece& piece, const std::string& id) {
  std::string name = id;
  for (int i = 2; find_edge(piece, name); ++i) name = id + "_" + std::to_string(i);
  return name;
}

void draw_edge(Drawing& drawing, const Piece& whole, int index, double begin, double end) {
  const Edge& edge = whole.outline[static_cast<std::size_t>(index)];
  if ((end - begin) * length(edge) < least_edge) return;
  Edge part = edge;
  part.id = free_id(drawing.piece, edge.id);
  if (begin > 0 || end < 1) {
    part.points.clear();
    const auto points = part_of<2>(positions(edge), begin, end);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool end_point = i == 0 || i + 1 == points.size();
      const double off = std::min((points[i] - points.front()).norm(), (points[i] - points.back()).norm());
      if (end_point || off > least_bend) part.points.push_back({points[i], end_point, {}});
    }
  }
  drawing.kept.emplace_back(index, KeptEdge{0, part.id, begin, end});
  drawing.piece.outline.push_back(std::move(part));
}

void draw_chord(Drawing& drawing, const Chord& chord, std::size_t index, bool along) {
  Edge edge;
  edge.id = free_id(drawing.piece, "mix");
  for (const Eigen::Vector2d& point : chord.points) edge.points.push_back({point, false, {}});
  if (!along) std::reverse(edge.points.begin(), edge.points.end());
  edge.points.front().turn = edge.points.back().turn = true;
  drawing.cut.emplace_back(index, CutEdge{0, edge.id, along});
  drawing.piece.outline.push_back(std::move(edge));
}

// The outlines of a cut piece on one side. Where a kept stretch of its outline ends, the chord leads to the start of the next.
std::vector<Drawing> drawings(const Piece& whole, const PieceGroup& group, bool beyond) {
  struct End {
    OutlinePlace place;
    std::size_t chord;
    bool kept_after;
  };
  std::vector<End> ends;
  for (std::size_t c = 0; c < group.chords.size(); ++c) {
    const Chord& chord = group.chords[c];
    const bool left = chord.beyond_left == beyond;
    ends.push_back({chord.from, c, !left});
    ends.push_back({chord.to, c, left});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return a.place.edge != b.place.edge ? a.place.edge < b.place.edge : a.place.at < b.place.at;
  });
  const auto count = static_cast<int>(whole.outline.size());
  std::vector<bool> done(ends.size(), false);
  std::vector<Drawing> found;
  for (std::size_t start = 0; start < ends.size(); ++start) {
    if (done[start] || !ends[start].kept_after) continue;
    Drawing drawing;
    for (std::size_t at = start; !done[at];) {
      done[at] = true;
      const std::size_t next = (at + 1) % ends.size();
      const OutlinePlace from = ends[at].place, to = ends[next].place;
      if (from.edge == to.edge && to.at >= from.at && next > at) {
        draw_edge(drawing, whole, from.edge, from.at, to.at);
      } else {
        draw_edge(drawing, whole, from.edge, from.at, 1);
        for (int e = (from.edge + 1) % count; e != to.edge; e = (e + 1) % count) draw_edge(drawing, whole, e, 0, 1);
        draw_edge(drawing, whole, to.edge, 0, to.at);
      }
      const std::size_t chord = ends[next].chord;
      const std::size_t other = static_cast<std::size_t>(
          std::find_if(ends.begin(), ends.end(), [&](const End& e) { return e.chord == chord && &e != &ends[next]; }) -
          ends.begin());
      draw_chord(drawing, group.chords[chord], chord, group.chords[chord].beyond_left == beyond);
      at = other;
    }
    found.push_back(std::move(drawing));
  }
  return found;
}

// Which copies of a piece went where.
struct Fate {
  std::vector<KeptEdge> edges;  // with the edge's index beside
  std::vector<int> edge_index;
  std::vector<std::pair<std::size_t, CutEdge>> cut;
  std::map<int, int> copy;  // of the whole piece -> of the new ones
};

using Fates = std::map<std::pair<int, int>, Fate>;  // (piece, copy)

struct Stretch {
  double from = 0, to = 1;  // along the seam
  const KeptEdge* edge = nullptr;
  int copy = 1;
};

std::vector<Stretch> stretches(const Pattern& pattern, const Fates& fates, const EdgeSpan& span) {
  const Piece* piece = find_piece(pattern, span.piece);
  const auto index = static_cast<int>(piece - pattern.pieces.data());
  const auto edge = static_cast<int>(find_edge(*piece, span.edge) - piece->outline.data());
  std::vector<Stretch> found;
  const auto fate = fates.find({index, span.copy});
  if (fate == fates.end()) return found;
  for (std::size_t k = 0; k < fate->second.edges.size(); ++k) {
    const KeptEdge& kept = fate->second.edges[k];
    if (fate->second.edge_index[k] != edge) continue;
    const double a = (kept.begin - span.begin) / (span.end - span.begin), b = (kept.end - span.begin) / (span.end - span.begin);
    const double from = std::max(0.0, std::min(a, b)), to = std::min(1.0, std::max(a, b));
    if (from < to) found.push_back({from, to, &kept, fate->second.copy.at(kept.piece)});
  }
  return found;
}

EdgeSpan span_on(const Part& part, const EdgeSpan& whole, const Stretch& stretch, double from, double to) {
  const KeptEdge& edge = *stretch.edge;
  const auto at = [&](double s) {
    const double share = (whole.begin + s * (whole.end - whole.begin) - edge.begin) / (edge.end - edge.begin);
    return share < 1e-7 ? 0.0 : share > 1 - 1e-7 ? 1.0 : share;
  };
  return {part.pattern.pieces[static_cast<std::size_t>(edge.piece)].name, stretch.copy, edge.id, at(from), at(to)};
}

void take_seams(const Pattern& pattern, const Fates& fates, Part& part) {
  constexpr double least = 2e-3;  // m
  for (const Seam& seam : pattern.seams) {
    const double length = std::min(span_length(pattern, seam.a), span_length(pattern, seam.b));
    for (const Stretch& a : stretches(pattern, fates, seam.a))
      for (const Stretch& b : stretches(pattern, fates, seam.b)) {
        const double from = std::max(a.from, b.from), to = std::min(a.to, b.to);
        if ((to - from) * length < least) continue;
        Seam kept = seam;
        // What is left of a seam on one side is all of what is left on the other: they were cut at one place.
        const double slack = least / length;
        const double a_from = std::abs(a.from - from) < slack ? a.from : from, a_to = std::abs(a.to - to) < slack ? a.to : to;
        const double b_from = std::abs(b.from - from) < slack ? b.from : from, b_to = std::abs(b.to - to) < slack ? b.to : to;
        kept.a = span_on(part, seam.a, a, a_from, a_to);
        kept.b = span_on(part, seam.b, b, b_from, b_to);
        part.pattern.seams.push_back(kept);
      }
  }
}

// The kept side's edges along a seam, in the order of the loop.
std::vector<EdgeSpan> ring_of_seam(const EditInput& input, const Parting& parting, const Fates& fates, const Part& part,
                                   const VertexLoop& loop, bool beyond) {
  std::map<std::pair<int, int>, std::vector<BoundarySegment>> by_ends;
  for (const BoundarySegment& s : boundary_segments(input.garment)) {
    const auto p = static_cast<std::size_t>(s.panel);
    by_ends[{input.garment.welded[p](s.from), input.garment.welded[p](s.to)}].push_back(s);
  }
  std::vector<EdgeSpan> ring;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int u = loop[i], v = loop[(i + 1) % loop.size()];
    for (const bool along : {true, false})
      for (const BoundarySegment& s : by_ends[along ? std::pair{u, v} : std::pair{v, u}]) {
        if (parting.panels[static_cast<std::size_t>(s.panel)].beyond != beyond) continue;
        const PanelMesh& panel = input.garment.panels[static_cast<std::size_t>(s.panel)];
        const Fate& fate = fates.at({panel.piece, panel.copy});
        for (std::size_t k = 0; k < fate.edges.size(); ++k) {
          if (fate.edge_index[k] != s.edge) continue;
          const std::string& name = part.pattern.pieces[static_cast<std::size_t>(fate.edges[k].piece)].name;
          const EdgeSpan span{name, fate.copy.at(fate.edges[k].piece), fate.edges[k].id, along ? s.begin : s.end,
                              along ? s.end : s.begin};
          if (!ring.empty() && ring.back().piece == span.piece && ring.back().copy == span.copy &&
              ring.back().edge == span.edge && std::abs(ring.back().end - span.begin) < 1e-9)
            ring.back().end = span.end;
          else
            ring.push_back(span);
        }
      }
  }
  if (ring.size() > 1 && ring.front().piece == ring.back().piece && ring.front().copy == ring.back().copy &&
      ring.front().edge == ring.back().edge && std::abs(ring.back().end - ring.front().begin) < 1e-9) {
    ring.front().begin = ring.back().begin;
    ring.pop_back();
  }
  return ring;
}

}  // namespace

Part take_part(const EditInput& input, const Parting& parting, bool beyond, const std::string& place) {
  const std::vector<PieceGroup> groups = even_chords(input, parting);
  Part part;
  part.pattern = input.pattern;
  part.pattern.pieces.clear();
  part.pattern.seams.clear();
  Fates fates;
  std::vector<std::map<int, EdgeSpan>> ranked(parting.loops.size());
  for (const PieceGroup& group : groups) {
    const Piece& whole = input.pattern.pieces[static_cast<std::size_t>(group.piece)];
    std::vector<Drawing> drawn;
    if (!group.chords.empty()) {
      drawn = drawings(whole, group, beyond);
    } else if (group.beyond == beyond) {
      drawn.resize(1);
      for (int e = 0; e < static_cast<int>(whole.outline.size()); ++e) draw_edge(drawn[0], whole, e, 0, 1);
    }
    for (Drawing& drawing : drawn) {
      const auto index = static_cast<int>(part.pattern.pieces.size());
      Piece piece = marked_like(whole, drawing.piece.outline, group.copies);
      for (int i = 2; find_piece(part.pattern, piece.name); ++i) piece.name = whole.name + "_" + std::to_string(i);
      for (const auto& [edge, kept] : drawing.kept) keep_notches(piece, whole, edge, kept.id, kept.begin, kept.end);
      for (std::size_t k = 0; k < group.copies.size(); ++k) {
        Fate& fate = fates[{group.piece, group.copies[k]}];
        fate.copy[index] = static_cast<int>(k) + 1;
        for (auto [edge, kept] : drawing.kept) {
          kept.piece = index;
          fate.edges.push_back(kept);
          fate.edge_index.push_back(edge);
        }
        for (auto [chord, cut] : drawing.cut) {
          const Chord& of_copy = group.copy_chords[k][chord];
          const bool along = cut.along != group.turned[k][chord];
          ranked[static_cast<std::size_t>(of_copy.loop)][of_copy.rank] = {piece.name, static_cast<int>(k) + 1, cut.id,
                                                                          along ? 0.0 : 1.0, along ? 1.0 : 0.0};
        }
      }
      part.panels.push_back(group.panels);
      part.pattern.pieces.push_back(std::move(piece));
    }
  }
  if (part.pattern.pieces.empty())
    throw BadInput({"edit.nothing-left", Severity::error, place, "nothing of the garment is on the side that is kept",
                    "keep the other side, or choose another loop"});
  take_seams(input.pattern, fates, part);
  const auto axes = trunk_and_limbs(input.body.form);
  for (std::size_t i = 0; i < parting.loops.size(); ++i) {
    std::vector<EdgeSpan> ring;
    if (parting.loops[i].seam.empty())
      for (const auto& [rank, span] : ranked[i]) ring.push_back(span);
    else
      ring = ring_of_seam(input, parting, fates, part, parting.loops[i].seam, beyond);
    part.rings.push_back(std::move(ring));
    part.across.push_back(parting.loops[i].seam.empty());
    part.limbs.push_back(limb_inside(input.body, axes, points_of(parting.loops[i], input.drape)));
  }
  return part;
}

}  // namespace toile
