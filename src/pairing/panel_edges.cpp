#include "pairing/panel_edges.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr int headings = 8;

// Turns the piece so that its grain stands upright. A grain line has no head, so pieces are turned by less than 90 degrees;
// one that lies exactly across may hang either way.
struct Upright {
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
  double sure = 1;
};

Upright upright(const Piece& piece, bool band) {
  Upright out;
  if (band) {
    Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const Edge& edge : piece.outline)
      for (const OutlinePoint& point : edge.points) {
        low = low.cwiseMin(point.at);
        high = high.cwiseMax(point.at);
      }
    if (high.y() - low.y() > 1.5 * (high.x() - low.x())) {
      out.turn << 0, 1, -1, 0;
      out.sure = .3;  // which of its long sides is up nobody knows
    }
    return out;
  }
  if (!piece.grainline) return out;
  Eigen::Vector2d up = piece.grainline->to - piece.grainline->from;
  if (up.norm() < 1e-6) return out;
  up.normalize();
  if (up.y() < 0) up = -up;
  if (up.y() < .9) {
    out.sure = up.y() < .5 ? .3 : .7;
    return out;  // bias, or a piece drawn lying: it hangs as drawn for all that is known
  }
  out.turn << up.y(), -up.x(), up.x(), up.y();
  return out;
}

double angle_between(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
}

// Direction over the first `reach` metres: what a corner's angle is judged by, whatever tiny segments a curve begins with.
Eigen::Vector2d leaving(const Points<2>& points, double length) {
  const double reach = std::min(.25, 5e-3 / std::max(length, 1e-9));
  return (point_at<2>(points, reach) - points.front()).normalized();
}

Eigen::Vector2d arriving(const Points<2>& points, double length) {
  const double reach = std::min(.25, 5e-3 / std::max(length, 1e-9));
  return (points.back() - point_at<2>(points, 1 - reach)).normalized();
}

Points<2> walked(const Pattern& pattern, const PanelEdges& all, const PanelEdge& edge) {
  const Panel& panel = all.panels[static_cast<std::size_t>(edge.panel)];
  const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
  Points<2> points = part_of<2>(positions(piece.outline[static_cast<std::size_t>(edge.edge)]), edge.begin, edge.end);
  for (Eigen::Vector2d& at : points) {
    at = panel.turn * at;
    if (is_mirrored(piece, panel.copy)) at.x() = -at.x();
  }
  return points;
}

void measure(const Pattern& pattern, const PanelEdges& all, PanelEdge& edge) {
  const Points<2> points = walked(pattern, all, edge);
  edge.length = polyline_length<2>(points);
  const Eigen::Vector2d chord = points.back() - points.front();
  edge.along = chord.norm() > 1e-9 ? Eigen::Vector2d(chord.normalized()) : leaving(points, edge.length);
  edge.outward = {edge.along.y(), -edge.along.x()};
  edge.heading.clear();
  for (int k = 0; k < headings; ++k) {
    const double from = double(k) / headings, to = double(k + 1) / headings;
    edge.heading.push_back(angle_between(edge.along, point_at<2>(points, to) - point_at<2>(points, from)));
  }
  const Panel& panel = all.panels[static_cast<std::size_t>(edge.panel)];
  const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
  edge.sure = panel.sure;
  edge.notches.clear();
  for (const Notch& notch : piece.notches) {
    if (notch.edge != piece.outline[static_cast<std::size_t>(edge.edge)].id) continue;
    const double at = (notch.at - edge.begin) / (edge.end - edge.begin);
    if (at * edge.length > 3e-3 && (1 - at) * edge.length > 3e-3) edge.notches.push_back(at);
  }
  std::sort(edge.notches.begin(), edge.notches.end());
}

}  // namespace

PanelEdges panel_edges(const Pattern& pattern, const std::vector<bool>& sewn, const std::vector<bool>& bands) {
  PanelEdges all;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    const Piece& piece = pattern.pieces[p];
    const int count = static_cast<int>(piece.outline.size());
    for (int copy = 1; sewn[p] && count > 0 && copy <= copies(piece); ++copy) {
      const int first = static_cast<int>(all.edges.size());
      Panel panel{static_cast<int>(p), copy, first, count};
      panel.area = std::abs(signed_area(piece));
      const Upright worn = upright(piece, bands[p]);
      panel.turn = worn.turn;
      panel.sure = worn.sure;
      all.panels.push_back(panel);
      const bool mirrored = is_mirrored(piece, copy);
      std::vector<Points<2>> runs;
      Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
      for (int k = 0; k < count; ++k) {
        PanelEdge edge;
        edge.panel = static_cast<int>(all.panels.size()) - 1;
        edge.edge = mirrored ? count - 1 - k : k;
        edge.begin = mirrored ? 1 : 0;
        edge.end = mirrored ? 0 : 1;
        edge.next = first + (k + 1) % count;
        edge.previous = first + (k + count - 1) % count;
        measure(pattern, all, edge);
        runs.push_back(walked(pattern, all, edge));
        for (const Eigen::Vector2d& at : runs.back()) {
          low = low.cwiseMin(at);
          high = high.cwiseMax(at);
        }
        all.edges.push_back(edge);
      }
      all.panels.back().width = high.x() - low.x();
      all.panels.back().height = high.y() - low.y();
      for (int k = 0; k < count; ++k) {
        const auto now = static_cast<std::size_t>(k), before = static_cast<std::size_t>((k + count - 1) % count);
        const double turn = angle_between(arriving(runs[before], polyline_length<2>(runs[before])),
                                          leaving(runs[now], polyline_length<2>(runs[now])));
        all.edges[static_cast<std::size_t>(first + k)].angle = std::numbers::pi - turn;
      }
    }
  }
  return all;
}

std::vector<int> split_edge(const Pattern& pattern, PanelEdges& all, int index, const std::vector<double>& shares) {
  const PanelEdge whole = all.edges[static_cast<std::size_t>(index)];
  std::vector<double> ends = shares;
  ends.push_back(1);
  std::vector<int> parts;
  double from = 0;
  for (const double to : ends) {
    PanelEdge part = whole;
    part.begin = whole.begin + from * (whole.end - whole.begin);
    part.end = whole.begin + to * (whole.end - whole.begin);
    measure(pattern, all, part);
    if (parts.empty()) {
      parts.push_back(index);
      all.edges[static_cast<std::size_t>(index)] = part;
    } else {
      part.angle = std::numbers::pi;
      part.previous = parts.back();
      parts.push_back(static_cast<int>(all.edges.size()));
      all.edges[static_cast<std::size_t>(part.previous)].next = parts.back();
      all.edges.push_back(part);
    }
    from = to;
  }
  all.edges[static_cast<std::size_t>(parts.back())].next = whole.next;
  all.edges[static_cast<std::size_t>(whole.next)].previous = parts.back();
  return parts;
}

EdgeSpan span_of(const Pattern& pattern, const PanelEdges& all, int index) {
  const PanelEdge& edge = all.edges[static_cast<std::size_t>(index)];
  const Panel& panel = all.panels[static_cast<std::size_t>(edge.panel)];
  const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
  return {piece.name, panel.copy, piece.outline[static_cast<std::size_t>(edge.edge)].id, edge.begin, edge.end};
}

EdgeSpan reversed(EdgeSpan span) {
  std::swap(span.begin, span.end);
  return span;
}

}  // namespace toile
