#pragma once
// Pieces to cut, drawn by hand.

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "cut/cut.h"
#include "cut/polygon.h"

namespace toile::testing {

using Points = std::vector<Eigen::Vector2d>;

inline Edge edge(const std::string& id, const Points& points, std::optional<double> allowance = {}) {
  Edge made;
  made.id = id;
  made.seam_allowance = allowance;
  for (std::size_t i = 0; i < points.size(); ++i)
    made.points.push_back({.at = points[i], .turn = i == 0 || i + 1 == points.size(), .grade_rule = {}});
  return made;
}

inline Piece piece(std::vector<Edge> outline) {
  Piece made;
  made.name = "piece";
  made.outline = std::move(outline);
  return made;
}

// Straight edges "e0", "e1", ... from corner to corner, counter-clockwise, with these allowances (the last for all the rest).
inline Piece polygon_piece(const Points& corners, const std::vector<double>& allowances = {0.01}) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < corners.size(); ++i)
    edges.push_back(edge("e" + std::to_string(i), {corners[i], corners[(i + 1) % corners.size()]},
                         allowances[std::min(i, allowances.size() - 1)]));
  return piece(std::move(edges));
}

inline Piece rectangle(double width, double height, const std::vector<double>& allowances = {0.01}) {
  return polygon_piece({{0, 0}, {width, 0}, {width, height}, {0, height}}, allowances);
}

// `count` + 1 points on a circle from angle `from` to `to`.
inline Points arc(const Eigen::Vector2d& centre, double radius, double from, double to, int count) {
  Points points;
  for (int i = 0; i <= count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.push_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return points;
}

inline Polygon places(const std::vector<OutlinePoint>& points) {
  Polygon at;
  for (const OutlinePoint& point : points) at.push_back(point.at);
  return at;
}

inline Polygon net_line(const Piece& piece) {
  Polygon net;
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) net.push_back(edge.points[i].at);
  return net;
}

inline double distance_to(const Polygon& loop, const Eigen::Vector2d& point) {
  double nearest = INFINITY;
  for (std::size_t i = 0; i < loop.size(); ++i)
    nearest = std::min(nearest, distance(point, loop[i], loop[(i + 1) % loop.size()]));
  return nearest;
}

}  // namespace toile::testing
