#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cut/cut.h"
#include "cut/offset.h"
#include "cut/overlaps.h"
#include "cut/piece_marks.h"

namespace toile {
namespace {

bool is_hem(const Edge& edge, const AllowanceRules& rules) {
  return edge.hem || std::find(rules.hem_edges.begin(), rules.hem_edges.end(), edge.id) != rules.hem_edges.end();
}

Line without_repeats(const std::vector<OutlinePoint>& points) {
  Line line;
  for (const OutlinePoint& point : points) {
    if (line.empty() || (point.at - line.back().at).norm() > 1e-9)
      line.push_back(point);
    else
      line.back().turn = line.back().turn || point.turn;
  }
  return line;
}

void check(const Piece& piece, const std::vector<double>& widths, const AllowanceRules& rules) {
  if (piece.outline.empty()) throw std::invalid_argument("add_allowance: piece '" + piece.name + "' has no outline");
  if (!(rules.mitre_limit >= 1) || rules.corner == Corner::mirrored) throw std::invalid_argument("add_allowance: rules");
  for (std::size_t e = 0; e < piece.outline.size(); ++e) {
    const Edge& edge = piece.outline[e];
    const Edge& next = piece.outline[(e + 1) % piece.outline.size()];
    if (!(widths[e] >= 0) || !std::isfinite(widths[e]))
      throw std::invalid_argument("add_allowance: allowance of edge '" + edge.id + "' of piece '" + piece.name + "'");
    if (edge.points.size() < 2 || !((edge.points.back().at - next.points.front().at).norm() <= 1e-6))
      throw std::invalid_argument("add_allowance: open outline of piece '" + piece.name + "' after edge '" + edge.id + "'");
  }
  if (!(signed_area(piece) > 0))
    throw std::invalid_argument("add_allowance: outline of piece '" + piece.name + "' is not counter-clockwise");
}

std::vector<OffsetEdge> offset_edges(const Piece& piece, const std::vector<double>& widths, const AllowanceRules& rules) {
  std::vector<OffsetEdge> edges;
  const auto add = [&](std::size_t e, Line sew) {
    edges.push_back(offset_edge(std::move(sew), widths[e], rules));
    edges.back().edge = static_cast<int>(e);
    edges.back().hem = is_hem(piece.outline[e], rules);
  };
  for (std::size_t e = 0; e < piece.outline.size(); ++e) {
    const Line sew = without_repeats(piece.outline[e].points);
    if (sew.size() < 2) continue;
    if (piece.outline.size() > 1) {
      add(e, sew);
      continue;
    }
    const auto half = sew.begin() + static_cast<std::ptrdiff_t>(sew.size() / 2);
    add(e, Line(sew.begin(), half + 1));
    add(e, Line(half, sew.end()));
  }
  return edges;
}

struct RawCutLine {
  Line line;
  bool sound = true;  // no edge turned over, all corners meet
};

RawCutLine put_together(const std::vector<OffsetEdge>& edges, const std::vector<Joint>& joints) {
  RawCutLine raw;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const OffsetEdge& edge = edges[e];
    const Joint& before = joints[(e + edges.size() - 1) % edges.size()];
    const double begin = before.out_begin;
    const double end = joints[e].in_end;
    raw.sound = raw.sound && before.meets && begin < end;
    raw.line.insert(raw.line.end(), before.points.begin(), before.points.end());
    for (std::size_t i = 1; i + 1 < edge.cut.size(); ++i) {
      const double place = static_cast<double>(i);
      if (place > begin + 1e-9 && place < end - 1e-9) raw.line.push_back(edge.cut[i]);
    }
    for (std::size_t i = 1; i < edge.cut.size() && edge.cut.size() == edge.sew.size(); ++i)
      if ((edge.cut[i].at - edge.cut[i - 1].at).dot(edge.sew[i].at - edge.sew[i - 1].at) < 0) raw.sound = false;
  }
  Line clean;
  for (const OutlinePoint& point : raw.line) {
    if (clean.empty() || (point.at - clean.back().at).norm() > same_place)
      clean.push_back(point);
    else
      clean.back().turn = clean.back().turn || point.turn;
  }
  while (clean.size() > 1 && (clean.back().at - clean.front().at).norm() <= same_place) clean.pop_back();
  raw.line = std::move(clean);
  return raw;
}

bool is_sound(const Line& cut, const std::vector<OffsetEdge>& edges) {
  const Polygon polygon = places(cut);
  return !first_self_crossing(polygon, touching) && signed_area(polygon) > 0 && !first_too_near(cut, edges);
}

Polygon net_polygon(const Piece& piece, const std::vector<OffsetEdge>& edges) {
  Polygon net;
  std::vector<std::string> edge_of;
  for (const OffsetEdge& edge : edges)
    for (std::size_t i = 0; i + 1 < edge.sew.size(); ++i) {
      net.push_back(edge.sew[i].at);
      edge_of.push_back(piece.outline[static_cast<std::size_t>(edge.edge)].id);
    }
  if (const auto crossed = first_self_crossing(net, touching))
    throw BadInput({.code = "cut.outline-crosses",
                    .place = "piece '" + piece.name + "', edges '" + edge_of[static_cast<std::size_t>(crossed->first)] +
                             "' and '" + edge_of[static_cast<std::size_t>(crossed->second)] + "'",
                    .text = "the net outline crosses or touches itself",
                    .remedy = "redraw these edges"});
  return net;
}

}  // namespace

CutPiece add_allowance(const Piece& piece, const AllowanceRules& rules) {
  std::vector<double> widths;
  std::vector<bool> hems;
  for (const Edge& edge : piece.outline) {
    hems.push_back(is_hem(edge, rules));
    widths.push_back(edge.seam_allowance.value_or(hems.back() ? rules.hem : rules.allowance));
  }
  check(piece, widths, rules);
  const std::vector<OffsetEdge> edges = offset_edges(piece, widths, rules);
  const Polygon net = net_polygon(piece, edges);
  std::vector<Joint> joints;
  for (std::size_t e = 0; e < edges.size(); ++e) joints.push_back(join(edges[e], edges[(e + 1) % edges.size()], rules));

  CutPiece cut;
  cut.piece = piece;
  RawCutLine raw = put_together(edges, joints);
  cut.cut_line =
      raw.sound && is_sound(raw.line, edges) ? std::move(raw.line) : united_cut_line(piece, net, edges, joints, raw.line);
  cut.notches = notches_on(piece, widths, places(cut.cut_line));
  cut.labels = labels_of(piece, widths, hems);
  return cut;
}

}  // namespace toile
