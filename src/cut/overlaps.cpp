#include "cut/overlaps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cut/outline_union.h"
#include "garment/report.h"

namespace toile {
namespace {

using Eigen::Vector2d;

constexpr double slack = 1e-6;          // m, of the guarantees
constexpr double smallest_hole = 1e-6;  // m^2, that could be cut

[[noreturn]] void refuse(const Piece& piece, const std::string& edge) {
  throw BadInput({.code = "cut.allowance-crosses",
                  .place = "piece '" + piece.name + "', edge '" + edge + "'",
                  .text = "there is no room for the seam allowance: it runs into the allowance of another part of the outline",
                  .remedy = "give this edge a smaller allowance, or divide the piece"});
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

// A leg goes on over turn points at which the outline hardly turns; at the mouth of the dart it turns by more than this.
bool goes_on(const OffsetEdge& in, const OffsetEdge& out) { return in.last.dot(out.first) > 0.8; }

// Which edges are the legs of a dart, or parts of them: from each point of a dart both ways.
std::vector<bool> dart_legs(const std::vector<OffsetEdge>& edges) {
  const std::size_t n = edges.size();
  std::vector<bool> legs(n, false);
  for (std::size_t point = 0; point < n; ++point) {
    if (!meet_in_a_dart(edges[point], edges[(point + 1) % n])) continue;
    for (std::size_t e = point, k = 0; k < n; ++k, e = (e + n - 1) % n) {
      legs[e] = true;
      if (!goes_on(edges[(e + n - 1) % n], edges[e])) break;
    }
    for (std::size_t e = (point + 1) % n, k = 0; k < n; ++k, e = (e + 1) % n) {
      legs[e] = true;
      if (!goes_on(edges[e], edges[(e + 1) % n])) break;
    }
  }
  return legs;
}

// Index of the edge whose strip ends at `point`, or nearest to it.
std::size_t edge_at(const std::vector<OffsetEdge>& edges, const Vector2d& point) {
  std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (std::size_t i = 1; i < edges[e].sew.size(); ++i) {
      const double apart = distance(point, edges[e].sew[i - 1].at, edges[e].sew[i].at);
      best = std::min(best, std::pair{std::abs(apart - edges[e].width), e});
    }
  return best.second;
}

// Whether the allowance of a dart's leg ends at `point`.
bool is_beside_leg(const std::vector<OffsetEdge>& edges, const std::vector<bool>& legs, const Vector2d& point) {
  for (std::size_t e = 0; e < edges.size(); ++e)
    for (std::size_t i = 1; legs[e] && i < edges[e].sew.size(); ++i)
      if (std::abs(distance(point, edges[e].sew[i - 1].at, edges[e].sew[i].at) - edges[e].width) < slack) return true;
  return false;
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
  // A slit that nobody could cut: the strips of two segments that turn by a rounding error part there.
  constexpr double hairline = 2e-6;  // m
  for (std::size_t i = 0; i < line.size() && line.size() > 4;) {
    const std::size_t next = (i + 1) % line.size(), after = (i + 2) % line.size();
    if ((line[i].at - line[after].at).norm() > hairline) {
      ++i;
      continue;
    }
    line[i].turn = false;
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(std::max(next, after)));
    line.erase(line.begin() + static_cast<std::ptrdiff_t>(std::min(next, after)));
    i = 0;
  }
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

}  // namespace

Polygon places(const Line& line) {
  Polygon points;
  for (const OutlinePoint& point : line) points.push_back(point.at);
  return points;
}

std::optional<std::size_t> first_too_near(const Line& cut, const std::vector<OffsetEdge>& edges) {
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
        if (beside < least && distance(a, b, sew[i - 1].at, sew[i].at) < least - slack) return e;
      }
  }
  return std::nullopt;
}

Line united_cut_line(const Piece& piece, const Polygon& net, const std::vector<OffsetEdge>& edges,
                     const std::vector<Joint>& joints, const Line& raw) {
  const auto strips = strips_of(edges, joints);
  std::vector<Polygon> fans;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    fans.insert(fans.end(), strips[e].begin(), strips[e].end());
    fans.insert(fans.end(), edges[e].patches.begin(), edges[e].patches.end());
    fans.insert(fans.end(), joints[e].patches.begin(), joints[e].patches.end());
  }
  const OutlineUnion all = unite(net, fans);
  const std::vector<bool> is_leg = dart_legs(edges);
  const auto name = [&](std::size_t e) { return piece.outline[static_cast<std::size_t>(edges[e].edge)].id; };
  for (const Polygon& hole : all.holes)
    for (const Vector2d& point : hole)
      if (std::abs(signed_area(hole)) > smallest_hole && !is_beside_leg(edges, is_leg, point))
        refuse(piece, name(edge_at(edges, point)));
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (!is_leg[e] && is_buried(edges[e], all.outer) && !has_part_on(all.outer, strips[e])) refuse(piece, name(e));
  Line line = flagged(all.outer, raw);
  if (const auto crossed = first_self_crossing(places(line), touching))
    refuse(piece, name(edge_at(edges, line[static_cast<std::size_t>(crossed->first)].at)));
  if (const auto near = first_too_near(line, edges)) refuse(piece, name(*near));
  return line;
}

}  // namespace toile
