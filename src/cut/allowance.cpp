#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cut/cut.h"
#include "cut/offset.h"
#include "cut/outline_union.h"
#include "cut/piece_marks.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double same_place = 1e-7;  // m
constexpr double slack = 1e-6;       // m, of the guarantees

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

Polygon places(const Line& line) {
  Polygon points;
  for (const OutlinePoint& point : line) points.push_back(point.at);
  return points;
}

[[noreturn]] void refuse(const Piece& piece, const std::string& edge) {
  throw BadInput({.code = "cut.allowance-crosses",
                  .place = "piece '" + piece.name + "', edge '" + edge + "'",
                  .text = "there is no room for the seam allowance: it runs into the allowance of another part of the outline",
                  .remedy = "give this edge a smaller allowance, or divide the piece"});
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

// The first edge whose guarantee (1) does not hold; empty when all do.
std::optional<int> first_too_near(const Line& cut, const std::vector<OffsetEdge>& edges) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const double least =
        std::min({edges[e].width, edges[(e + 1) % edges.size()].width, edges[(e + edges.size() - 1) % edges.size()].width});
    if (least <= slack) continue;
    const Line& sew = edges[e].sew;
    for (std::size_t i = 1; i < sew.size(); ++i)
      for (std::size_t j = 0; j < cut.size(); ++j) {
        const Vector2d& a = cut[j].at;
        const Vector2d& b = cut[(j + 1) % cut.size()].at;
        const double beside = (a - sew[i].at).norm() - (b - a).norm() - (sew[i].at - sew[i - 1].at).norm();
        if (beside < least && distance(a, b, sew[i - 1].at, sew[i].at) < least - slack) return edges[e].edge;
      }
  }
  return std::nullopt;
}

bool is_sound(const Line& cut, const std::vector<OffsetEdge>& edges) {
  const Polygon polygon = places(cut);
  return !first_self_crossing(polygon) && signed_area(polygon) > 0 && !first_too_near(cut, edges);
}

// The strips beside the edges' segments, by edge.
std::vector<std::vector<Polygon>> strips_of(const std::vector<OffsetEdge>& edges, const std::vector<Joint>& joints) {
  std::vector<std::vector<Polygon>> strips(edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const OffsetEdge& edge = edges[e];
    if (edge.width <= 0) continue;
    for (std::size_t i = 1; i < edge.sew.size(); ++i) {
      const Vector2d a = edge.sew[i - 1].at;
      const Vector2d b = edge.sew[i].at;
      const Vector2d out = edge.width * turned_right((b - a).normalized());
      strips[e].push_back({a, a + out, b + out, b});
    }
    const auto& start = joints[(e + edges.size() - 1) % edges.size()].out_trimmed;
    if (start) strips[e].front()[1] = *start;
    if (joints[e].in_trimmed) strips[e].back()[2] = *joints[e].in_trimmed;
  }
  return strips;
}

bool has_part_on(const Polygon& outline, const std::vector<Polygon>& strips) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d middle = (outline[i] + outline[(i + 1) % outline.size()]) / 2;
    for (const Polygon& strip : strips)
      if (distance(outline[i], strip[1], strip[2]) < slack && distance(middle, strip[1], strip[2]) < slack) return true;
  }
  return false;
}

// Whether the edge lies so far inside the cut line that nobody could find it by its allowance.
bool is_buried(const OffsetEdge& edge, const Polygon& outline) {
  return edge.width > 0 && std::any_of(edge.sew.begin(), edge.sew.end(), [&](const OutlinePoint& point) {
           double nearest = std::numeric_limits<double>::infinity();
           for (std::size_t i = 0; i < outline.size(); ++i)
             nearest = std::min(nearest, distance(point.at, outline[i], outline[(i + 1) % outline.size()]));
           return nearest > 4 * edge.width;
         });
}

bool meet_in_a_dart(const OffsetEdge& in, const OffsetEdge& out) {
  return cross(in.last, out.first) < 0 && in.last.dot(out.first) < -0.5;
}

const std::string& nearest_edge(const Piece& piece, const std::vector<OffsetEdge>& edges, const Vector2d& point) {
  std::pair<double, int> best{std::numeric_limits<double>::infinity(), 0};
  for (const OffsetEdge& edge : edges)
    for (std::size_t i = 1; i < edge.sew.size(); ++i)
      best = std::min(best, std::pair{distance(point, edge.sew[i - 1].at, edge.sew[i].at) - edge.width, edge.edge});
  return piece.outline[static_cast<std::size_t>(best.second)].id;
}

// The points of the union's outline with the flags of the raw cut line's points they came from.
Line flagged(const Polygon& outline, const Line& raw) {
  Line line;
  for (const Vector2d& at : outline) {
    const auto known =
        std::find_if(raw.begin(), raw.end(), [&](const OutlinePoint& p) { return (p.at - at).norm() <= same_place; });
    if (!line.empty() && (line.back().at - at).norm() <= same_place) continue;
    line.push_back(known != raw.end() ? *known : OutlinePoint{.at = at, .turn = true, .grade_rule = {}});
    line.back().at = at;
  }
  while (line.size() > 1 && (line.back().at - line.front().at).norm() <= same_place) line.pop_back();
  for (std::size_t i = 0; i < line.size() && line.size() > 3;) {
    const Vector2d& before = line[(i + line.size() - 1) % line.size()].at;
    const Vector2d& after = line[(i + 1) % line.size()].at;
    if (distance(line[i].at, before, after) < 1e-8)
      line.erase(line.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  return line;
}

Line united(const Piece& piece, const Polygon& net, const std::vector<OffsetEdge>& edges, const std::vector<Joint>& joints,
            const Line& raw) {
  const auto strips = strips_of(edges, joints);
  std::vector<Polygon> fans;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    fans.insert(fans.end(), strips[e].begin(), strips[e].end());
    fans.insert(fans.end(), edges[e].patches.begin(), edges[e].patches.end());
    fans.insert(fans.end(), joints[e].patches.begin(), joints[e].patches.end());
  }
  const OutlineUnion all = unite(net, fans);
  for (const Polygon& hole : all.holes)
    if (std::abs(signed_area(hole)) > 1e-6) refuse(piece, nearest_edge(piece, edges, hole.front()));
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const OffsetEdge& edge = edges[e];
    const OffsetEdge& next = edges[(e + 1) % edges.size()];
    const OffsetEdge& before = edges[(e + edges.size() - 1) % edges.size()];
    if (meet_in_a_dart(edge, next) || meet_in_a_dart(before, edge)) continue;
    if (is_buried(edge, all.outer) && !has_part_on(all.outer, strips[e]))
      refuse(piece, piece.outline[static_cast<std::size_t>(edge.edge)].id);
  }
  Line line = flagged(all.outer, raw);
  if (first_self_crossing(places(line)))
    refuse(piece, nearest_edge(piece, edges, line[static_cast<std::size_t>(first_self_crossing(places(line))->first)].at));
  if (const auto edge = first_too_near(line, edges)) refuse(piece, piece.outline[static_cast<std::size_t>(*edge)].id);
  return line;
}

Polygon net_polygon(const Piece& piece, const std::vector<OffsetEdge>& edges) {
  Polygon net;
  std::vector<std::string> edge_of;
  for (const OffsetEdge& edge : edges)
    for (std::size_t i = 0; i + 1 < edge.sew.size(); ++i) {
      net.push_back(edge.sew[i].at);
      edge_of.push_back(piece.outline[static_cast<std::size_t>(edge.edge)].id);
    }
  if (const auto crossed = first_self_crossing(net))
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
  cut.cut_line = raw.sound && is_sound(raw.line, edges) ? std::move(raw.line) : united(piece, net, edges, joints, raw.line);
  cut.notches = notches_on(piece, widths, places(cut.cut_line));
  cut.labels = labels_of(piece, widths, hems);
  return cut;
}

}  // namespace toile
