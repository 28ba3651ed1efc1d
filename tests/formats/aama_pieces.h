#pragma once
// Pieces drafted in the tests: straight and curved edges, allowances of several widths, everything a piece can carry.

#include <cmath>

#include "garment/cut_sheet.h"
#include "garment/pattern.h"

namespace toile {

struct DraftedEdge {
  std::vector<Eigen::Vector2d> points;  // m, both ends included
  double allowance;                     // m
};

inline Piece drafted_piece(const std::string& name, const std::vector<DraftedEdge>& edges) {
  Piece piece;
  piece.name = name;
  for (const DraftedEdge& drafted : edges) {
    Edge edge;
    edge.id = "e" + std::to_string(piece.outline.size());
    edge.seam_allowance = drafted.allowance;
    for (const Eigen::Vector2d& p : drafted.points) edge.points.push_back({p, false, {}});
    edge.points.front().turn = edge.points.back().turn = true;
    piece.outline.push_back(std::move(edge));
  }
  return piece;
}

// The cut line of a counter-clockwise outline without tight bends: each segment moved out, neighbours prolonged to meet.
inline std::vector<OutlinePoint> mitred(const Piece& piece) {
  struct Side {
    Eigen::Vector2d from, to;
    bool turn;
  };
  std::vector<Side> sides;
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Eigen::Vector2d a = edge.points[i - 1].at, b = edge.points[i].at, d = (b - a).normalized();
      const Eigen::Vector2d out = *edge.seam_allowance * Eigen::Vector2d(d.y(), -d.x());
      sides.push_back({a + out, b + out, i == 1});
    }
  std::vector<OutlinePoint> line;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& p = sides[(i + sides.size() - 1) % sides.size()];
    const Side& q = sides[i];
    const Eigen::Vector2d u = p.to - p.from, v = q.to - q.from;
    const double cross = u.x() * v.y() - u.y() * v.x();
    Eigen::Vector2d at = q.from;
    if (std::abs(cross) > 1e-9) {
      const Eigen::Vector2d w = q.from - p.from;
      at = p.from + (w.x() * v.y() - w.y() * v.x()) / cross * u;
    }
    line.push_back({at, q.turn, {}});
  }
  return line;
}

inline Eigen::Vector2d on_edge(const Edge& edge, double at, Eigen::Vector2d* inwards = nullptr) {
  double wanted = at * length(edge);
  for (std::size_t i = 1; i < edge.points.size(); ++i) {
    const Eigen::Vector2d d = edge.points[i].at - edge.points[i - 1].at;
    if (wanted > d.norm() && i + 1 < edge.points.size()) {
      wanted -= d.norm();
      continue;
    }
    if (inwards) *inwards = Eigen::Vector2d(-d.y(), d.x()).normalized();
    return edge.points[i - 1].at + wanted / d.norm() * d;
  }
  return edge.points.back().at;
}

inline CutPiece cut_piece(const Piece& piece, const std::string& size = "38") {
  CutPiece cut;
  cut.piece = piece;
  cut.size = size;
  cut.cut_line = mitred(piece);
  for (const Notch& notch : piece.notches) {
    const Edge& edge = *find_edge(piece, notch.edge);
    Eigen::Vector2d inwards = Eigen::Vector2d::UnitX();
    const Eigen::Vector2d on_sew = on_edge(edge, notch.at, &inwards);
    cut.notches.push_back({on_sew - *edge.seam_allowance * inwards, inwards, notch});
  }
  cut.labels = {piece.name};
  return cut;
}

// y over x as a run of points: a shallow curve from (x0, y0) to (x1, y1) with `sag` m to its left.
inline std::vector<Eigen::Vector2d> curve(Eigen::Vector2d a, Eigen::Vector2d b, double sag, int segments) {
  std::vector<Eigen::Vector2d> points;
  const Eigen::Vector2d left = Eigen::Vector2d(-(b - a).y(), (b - a).x()).normalized();
  for (int i = 0; i <= segments; ++i) {
    const double t = double(i) / segments;
    points.push_back(a + t * (b - a) + 4 * sag * t * (1 - t) * left);
  }
  return points;
}

// A gore: hem curved and 40 mm deep, sides curved, waist straight and on the cut (no allowance), with one of everything.
inline Piece gore() {
  Piece piece = drafted_piece("gore", {{curve({-.18, 0}, {.18, 0}, -.012, 24), 40e-3},
                                       {curve({.18, 0}, {.09, .6}, -.01, 31), 15e-3},
                                       {{{.09, .6}, {-.09, .6}}, 0},
                                       {curve({-.09, .6}, {-.18, 0}, -.01, 31), 15e-3}});
  piece.quantity = 3;
  piece.mirrored_quantity = 3;
  piece.material = "denim";
  piece.notches = {{"e1", .25, NotchKind::slit, 5e-3, 0}, {"e1", .7, NotchKind::v, 4e-3, 3e-3},
                   {"e3", .3, NotchKind::t, 4e-3, 2e-3},  {"e3", .5, NotchKind::castle, 4e-3, 3e-3},
                   {"e0", .5, NotchKind::u, 6e-3, 2e-3},  {"e2", .5, NotchKind::check, 4e-3, 3e-3}};
  piece.drill_holes = {{{.01, .3}, 3e-3}, {{-.02, .4}, 0}};
  piece.internal_lines = {{{{0, .1}, {0, .5}}, false}, {{{.02, .2}, {.05, .2}, {.05, .25}, {.02, .25}, {.02, .2}}, true}};
  piece.grainline = Grainline{{-.01, .1}, {.02, .5}};
  piece.annotations = {"press seams open", "attention: one way"};
  return piece;
}

inline Piece band(double width = .7, double height = .04) {
  Piece piece = drafted_piece("waist band", {{{{0, 0}, {width, 0}}, 10e-3},
                                             {{{width, 0}, {width, height}}, 10e-3},
                                             {{{width, height}, {0, height}}, 10e-3},
                                             {{{0, height}, {0, 0}}, 10e-3}});
  piece.grainline = Grainline{{.1, .02}, {.3, .02}};
  return piece;
}

// A disc: one closed edge, one turn point.
inline Piece disc() {
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i <= 48; ++i) circle.emplace_back(.1 * std::cos(i * M_PI / 24), .1 * std::sin(i * M_PI / 24));
  circle.back() = circle.front();
  Piece piece = drafted_piece("disc", {{circle, 8e-3}});
  piece.grainline = Grainline{{0, -.05}, {0, .05}};
  return piece;
}

inline CutSheet sheet_of(const std::vector<Piece>& pieces) {
  CutSheet sheet;
  sheet.title = "gored skirt";
  sheet.page_width = 1.5;
  sheet.page_length = 2;
  for (const Piece& piece : pieces) sheet.placed.push_back({cut_piece(piece), {.2, .1}, .3});
  sheet.notes = {"verified: 0.3 mm"};
  return sheet;
}

}  // namespace toile
