#include "garment/pattern.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace toile {

int copies(const Piece& piece) { return piece.quantity + piece.mirrored_quantity; }

bool is_mirrored(const Piece& piece, int copy) { return copy > piece.quantity; }

const Piece* find_piece(const Pattern& pattern, const std::string& name) {
  const auto found = std::find_if(pattern.pieces.begin(), pattern.pieces.end(), [&](const Piece& p) { return p.name == name; });
  return found == pattern.pieces.end() ? nullptr : &*found;
}

const Edge* find_edge(const Piece& piece, const std::string& id) {
  const auto found = std::find_if(piece.outline.begin(), piece.outline.end(), [&](const Edge& e) { return e.id == id; });
  return found == piece.outline.end() ? nullptr : &*found;
}

std::vector<Eigen::Vector2d> positions(const Edge& edge) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(edge.points.size());
  for (const OutlinePoint& point : edge.points) points.push_back(point.at);
  return points;
}

double length(const Edge& edge) {
  double sum = 0;
  for (std::size_t i = 1; i < edge.points.size(); ++i) sum += (edge.points[i].at - edge.points[i - 1].at).norm();
  return sum;
}

double span_length(const Pattern& pattern, const EdgeSpan& span) {
  const Piece* piece = find_piece(pattern, span.piece);
  const Edge* edge = piece ? find_edge(*piece, span.edge) : nullptr;
  if (!edge) throw std::invalid_argument("span_length: no edge '" + span.edge + "' in piece '" + span.piece + "'");
  return std::abs(span.end - span.begin) * length(*edge);
}

double signed_area(const Piece& piece) {
  double twice = 0;
  for (const Edge& edge : piece.outline)
    for (std::size_t i = 1; i < edge.points.size(); ++i) {
      const Eigen::Vector2d& a = edge.points[i - 1].at;
      const Eigen::Vector2d& b = edge.points[i].at;
      twice += a.x() * b.y() - a.y() * b.x();
    }
  return twice / 2;
}

bool is_straight(const Edge& edge, double tolerance) {
  const Eigen::Vector2d chord = edge.points.back().at - edge.points.front().at;
  const double chord_length = chord.norm();
  if (chord_length == 0) return false;
  return std::all_of(edge.points.begin(), edge.points.end(), [&](const OutlinePoint& point) {
    const Eigen::Vector2d d = point.at - edge.points.front().at;
    return std::abs(chord.x() * d.y() - chord.y() * d.x()) <= tolerance * chord_length;
  });
}

}  // namespace toile
