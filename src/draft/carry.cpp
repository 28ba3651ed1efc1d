#include "draft/carry.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>

namespace toile {
namespace {

Eigen::Vector2d carried(const Eigen::Vector2d& point, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& before,
                        const Eigen::Matrix2Xd& after) {
  double best = -std::numeric_limits<double>::infinity();
  Eigen::Vector2d result = point;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto edges = [&](const Eigen::Matrix2Xd& at) {
      Eigen::Matrix2d e;
      e << at.col(triangles(1, t)) - at.col(triangles(0, t)), at.col(triangles(2, t)) - at.col(triangles(0, t));
      return e;
    };
    const Eigen::Vector2d b = edges(before).inverse() * (point - before.col(triangles(0, t)));
    const double inside = std::min({b.x(), b.y(), 1 - b.x() - b.y()});  // negative outside
    if (inside <= best) continue;
    best = inside;
    result = after.col(triangles(0, t)) + edges(after) * b;
    if (inside >= 0) break;
  }
  return result;
}

}  // namespace

void carry_marks(Piece& piece, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& before,
                 const Eigen::Matrix2Xd& after) {
  const auto carry = [&](const Eigen::Vector2d& point) { return carried(point, triangles, before, after); };
  for (InternalLine& line : piece.internal_lines)
    for (Eigen::Vector2d& point : line.points) point = carry(point);
  for (DrillHole& hole : piece.drill_holes) hole.at = carry(hole.at);
  if (!piece.grainline) return;
  const Eigen::Vector2d along = piece.grainline->to - piece.grainline->from;
  if (along.norm() == 0) return;
  const Eigen::Vector2d direction = along.normalized(), from = carry(piece.grainline->from), to = carry(piece.grainline->to);
  const Eigen::Vector2d half = direction * std::max((to - from).dot(direction), 0.0) / 2;
  piece.grainline = Grainline{(from + to) / 2 - half, (from + to) / 2 + half};
}

}  // namespace toile
