#include "triangulate/outline.h"

#include <cstdio>
#include <string>

#include "garment/report.h"
#include "garment/units.h"
#include "geometry/self_crossing.h"

namespace toile {
namespace {

// Ends of consecutive edges further apart than this leave the outline open; nearer is a file's rounding.
constexpr double closing_tolerance = 1e-5;  // m

std::string in_cm(const Eigen::Vector2d& p) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f) cm", p.x() * cm_per_m, p.y() * cm_per_m);
  return text;
}

[[noreturn]] void refuse(const char* code, const Piece& piece, std::string text, std::string remedy) {
  throw BadInput({code, Severity::error, "piece '" + piece.name + "'", std::move(text), std::move(remedy), Fault::bad_input});
}

void check_edges(const Piece& piece) {
  if (piece.outline.empty()) refuse("pattern.no-outline", piece, "it has no outline", "Draw its net line or remove it");
  for (const Edge& edge : piece.outline) {
    if (edge.points.size() < 2)
      refuse("pattern.edge-without-length", piece, "edge '" + edge.id + "' has fewer than two points", "Remove the edge");
    for (const OutlinePoint& p : edge.points)
      if (!p.at.allFinite())
        refuse("pattern.not-finite", piece, "edge '" + edge.id + "' has a coordinate that is not a number",
               "Export the piece again");
    if (!(length(edge) > 0))
      refuse("pattern.edge-without-length", piece, "edge '" + edge.id + "' has no length", "Remove one of its turn points");
  }
  for (std::size_t e = 0; e < piece.outline.size(); ++e) {
    const Edge& edge = piece.outline[e];
    const Edge& next = piece.outline[(e + 1) % piece.outline.size()];
    const double gap = (next.points.front().at - edge.points.back().at).norm();
    if (gap > closing_tolerance)
      refuse("pattern.open-outline", piece,
             "edge '" + edge.id + "' ends at " + in_cm(edge.points.back().at) + ", " + in_mm(gap) + " from where edge '" +
                 next.id + "' starts",
             "Close the outline");
  }
}

}  // namespace

OutlinePolygon outline_polygon(const Piece& piece) {
  OutlinePolygon polygon;
  for (std::size_t e = 0; e < piece.outline.size(); ++e)
    for (std::size_t i = 0; i + 1 < piece.outline[e].points.size(); ++i) {
      const OutlinePoint& p = piece.outline[e].points[i];
      if (i > 0 && p.at == piece.outline[e].points[i - 1].at) continue;
      if (p.at == piece.outline[e].points[i + 1].at && i + 2 == piece.outline[e].points.size()) continue;
      polygon.corners.push_back(p.at);
      polygon.edge.push_back(static_cast<int>(e));
    }
  return polygon;
}

void check_outlines(const Pattern& pattern) {
  for (const Piece& piece : pattern.pieces) {
    check_edges(piece);
    const OutlinePolygon polygon = outline_polygon(piece);
    if (polygon.corners.size() < 3)
      refuse("pattern.self-crossing", piece, "the outline encloses nothing", "Draw its net line again");
    if (const auto crossing = first_self_crossing(polygon.corners)) {
      const auto edge = [&](int side) {
        return piece.outline[static_cast<std::size_t>(polygon.edge[static_cast<std::size_t>(side)])].id;
      };
      const Eigen::Vector2d at = polygon.corners[static_cast<std::size_t>(crossing->second)];
      refuse("pattern.self-crossing", piece,
             "the outline crosses or touches itself near " + in_cm(at) + ", where edge '" + edge(crossing->first) +
                 "' meets edge '" + edge(crossing->second) + "'",
             "Move the points apart so that the outline encloses one area");
    }
    if (signed_area(piece) <= 0)
      refuse("pattern.clockwise-outline", piece, "the outline runs clockwise",
             "Reverse it: counter-clockwise seen from the right side");
  }
}

}  // namespace toile
