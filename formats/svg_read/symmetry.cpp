#include "formats/svg_read/symmetry.h"

#include <algorithm>

#include "geometry/polyline.h"

namespace toile::svg {

bool is_symmetric(const Piece& piece) {
  constexpr double near = 2e-3;  // m
  Points<2> loop;
  for (const Edge& edge : piece.outline)
    for (const OutlinePoint& point : edge.points) loop.push_back(point.at);
  if (loop.size() < 3) return false;
  Eigen::Vector2d grain =
      piece.grainline ? Eigen::Vector2d(piece.grainline->to - piece.grainline->from) : Eigen::Vector2d::UnitY();
  if (grain.norm() < 1e-6) grain = Eigen::Vector2d::UnitY();
  grain.normalize();
  for (const Eigen::Vector2d& axis : {grain, Eigen::Vector2d(-grain.y(), grain.x())}) {
    const Eigen::Vector2d across(-axis.y(), axis.x());
    double low = across.dot(loop.front()), high = low;
    for (const Eigen::Vector2d& p : loop) {
      low = std::min(low, across.dot(p));
      high = std::max(high, across.dot(p));
    }
    const double middle = (low + high) / 2;
    if (std::all_of(loop.begin(), loop.end(), [&](const Eigen::Vector2d& p) {
          return nearest_on<2>(loop, p + 2 * (middle - across.dot(p)) * across).distance <= near;
        }))
      return true;
  }
  return false;
}

}  // namespace toile::svg
