#pragma once
// Small patterns drawn in code.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "garment/pattern.h"

namespace toile {

inline Edge straight_edge(const std::string& id, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Edge edge;
  edge.id = id;
  edge.points = {{from, true, {}}, {to, true, {}}};
  return edge;
}

// Circular arc from `from` to `to` about `centre`, the short way round.
inline Edge arc_edge(const std::string& id, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                     const Eigen::Vector2d& centre, int parts = 40) {
  Edge edge;
  edge.id = id;
  const Eigen::Vector2d u = from - centre, v = to - centre;
  const double begin = std::atan2(u.y(), u.x());
  const double turn = std::remainder(std::atan2(v.y(), v.x()) - begin, 2 * std::numbers::pi);
  for (int i = 0; i <= parts; ++i) {
    const double angle = begin + turn * i / parts;
    edge.points.push_back({centre + u.norm() * Eigen::Vector2d(std::cos(angle), std::sin(angle)), i == 0 || i == parts, {}});
  }
  edge.points.front().at = from;
  edge.points.back().at = to;
  return edge;
}

// Straight edges "e0", "e1", ... between the corners.
inline Piece polygon_piece(const std::string& name, const std::vector<Eigen::Vector2d>& corners) {
  Piece piece;
  piece.name = name;
  for (std::size_t i = 0; i < corners.size(); ++i)
    piece.outline.push_back(straight_edge("e" + std::to_string(i), corners[i], corners[(i + 1) % corners.size()]));
  return piece;
}

// "bottom", "right", "top", "left".
inline Piece rectangle(const std::string& name, double width, double height, const Eigen::Vector2d& corner = {0, 0}) {
  Piece piece = polygon_piece(name, {corner, corner + Eigen::Vector2d(width, 0), corner + Eigen::Vector2d(width, height),
                                     corner + Eigen::Vector2d(0, height)});
  const char* ids[] = {"bottom", "right", "top", "left"};
  for (std::size_t e = 0; e < 4; ++e) piece.outline[e].id = ids[e];
  return piece;
}

// A gore with curved waist and hem and straight sides: "hem", "right", "waist", "left".
inline Piece gore(double waist, double hem, double length) {
  const double radius = waist * length / (hem - waist);  // of the waist, about the point where the sides would meet
  const double half = hem / (radius + length) / 2;
  const auto at = [&](double r, double angle) { return Eigen::Vector2d(r * std::sin(angle), radius - r * std::cos(angle)); };
  Piece piece;
  piece.name = "gore";
  const Eigen::Vector2d centre(0, radius);
  piece.outline = {arc_edge("hem", at(radius + length, -half), at(radius + length, half), centre),
                   straight_edge("right", at(radius + length, half), at(radius, half)),
                   arc_edge("waist", at(radius, half), at(radius, -half), centre),
                   straight_edge("left", at(radius, -half), at(radius + length, -half))};
  return piece;
}

inline EdgeSpan span(const std::string& piece, int copy, const std::string& edge, double begin = 0, double end = 1) {
  return {piece, copy, edge, begin, end};
}

// `gores` copies of one gore round the body, on a waistband cut in one and closed at its short ends.
inline Pattern gored_skirt(int gores = 8) {
  Pattern pattern;
  pattern.name = "skirt";
  const double waist = .72;
  Piece piece = gore(waist / gores, 2.1 / gores, .6);
  piece.quantity = gores;
  pattern.pieces = {piece, rectangle("waistband", waist, .04)};
  for (int c = 1; c <= gores; ++c) {
    const std::string name = std::to_string(c);
    pattern.seams.push_back({"side " + name, span("gore", c, "right"), span("gore", c % gores + 1, "left", 1, 0), false});
    const double k = c - 1;
    pattern.seams.push_back(
        {"waist " + name, span("waistband", 1, "bottom", k / gores, (k + 1) / gores), span("gore", c, "waist", 1, 0), false});
  }
  pattern.seams.push_back({"band", span("waistband", 1, "right"), span("waistband", 1, "left", 1, 0), false});
  return pattern;
}

// A rectangle with a dart in its top edge, sewn shut: "leg1" runs to the point, "leg2" back.
inline Pattern darted_panel() {
  Pattern pattern;
  Piece piece = polygon_piece("back", {{0, 0}, {.3, 0}, {.3, .3}, {.17, .3}, {.15, .18}, {.13, .3}, {0, .3}});
  piece.outline[3].id = "leg1";
  piece.outline[4].id = "leg2";
  pattern.pieces = {piece};
  pattern.seams = {{"dart", span("back", 1, "leg1"), span("back", 1, "leg2", 1, 0), false}};
  return pattern;
}

// Left and right front, cut as a pair and sewn along the centre.
inline Pattern mirrored_fronts() {
  Pattern pattern;
  Piece piece;
  piece.name = "front";
  piece.mirrored_quantity = 1;
  piece.outline = {straight_edge("hem", {0, 0}, {.25, 0}),
                   straight_edge("side", {.25, 0}, {.22, .4}),
                   arc_edge("armhole", {.22, .4}, {.12, .55}, {.27, .54}),
                   straight_edge("shoulder", {.12, .55}, {.07, .57}),
                   arc_edge("neck", {.07, .57}, {0, .5}, {0, .57}),
                   straight_edge("centre", {0, .5}, {0, 0})};
  piece.grainline = Grainline{{.1, .1}, {.12, .4}};
  pattern.pieces = {piece};
  pattern.seams = {{"centre", span("front", 1, "centre"), span("front", 2, "centre"), false}};
  return pattern;
}

// A body sewn to a yoke that is `ratio` times shorter.
inline Pattern eased_seam(double ratio) {
  Pattern pattern;
  pattern.pieces = {rectangle("yoke", .3, .1), rectangle("body", .3 * ratio, .2)};
  pattern.seams = {{"gather", span("body", 1, "top"), span("yoke", 1, "bottom", 1, 0), false}};
  return pattern;
}

}  // namespace toile
