#include "cut/outline_union.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_set_2.h>

#include <array>
#include <stdexcept>

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using ExactPolygon = CGAL::Polygon_2<Kernel>;

Kernel::Point_2 exact(const Eigen::Vector2d& point) { return {point.x(), point.y()}; }

Polygon rounded(const ExactPolygon& polygon) {
  Polygon points;
  for (auto point = polygon.vertices_begin(); point != polygon.vertices_end(); ++point)
    points.emplace_back(CGAL::to_double(point->x()), CGAL::to_double(point->y()));
  return points;
}

}  // namespace

OutlineUnion unite(const Polygon& first, const std::vector<Polygon>& fans) {
  std::vector<ExactPolygon> parts(1);
  for (const Eigen::Vector2d& point : first) parts.front().push_back(exact(point));
  for (const Polygon& fan : fans)
    for (std::size_t i = 2; i < fan.size(); ++i) {
      const Kernel::Point_2 a = exact(fan[0]), b = exact(fan[i - 1]), c = exact(fan[i]);
      const CGAL::Orientation turn = CGAL::orientation(a, b, c);
      if (turn == CGAL::COLLINEAR) continue;
      const std::array<Kernel::Point_2, 3> corners = {a, turn == CGAL::LEFT_TURN ? b : c, turn == CGAL::LEFT_TURN ? c : b};
      parts.emplace_back(corners.begin(), corners.end());
    }
  CGAL::Polygon_set_2<Kernel> all;
  all.join(parts.begin(), parts.end());
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> found;
  all.polygons_with_holes(std::back_inserter(found));
  if (found.size() != 1) throw std::invalid_argument("unite: the parts do not hang together");
  OutlineUnion result{.outer = rounded(found.front().outer_boundary()), .holes = {}};
  for (auto hole = found.front().holes_begin(); hole != found.front().holes_end(); ++hole)
    result.holes.push_back(rounded(*hole));
  return result;
}

}  // namespace toile
