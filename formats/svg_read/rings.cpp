#include "formats/svg_read/rings.h"

#include <algorithm>

#include "formats/dxf_aama/chains.h"

namespace toile::svg {

using Eigen::Vector2d;

bool contains(const Points<2>& ring, const Eigen::Vector2d& at) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2d& a = ring[i];
    const Vector2d& b = ring[(i + 1) % ring.size()];
    if ((a.y() > at.y()) != (b.y() > at.y()) && at.x() < a.x() + (at.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      inside = !inside;
  }
  return inside;
}

bool is_within(const Ring& inner, const Ring& outer, double beside) {
  if (inner.area > outer.area * (1 + 1e-9) || !Box(inner.points).within(Box(outer.points), beside)) return false;
  std::size_t inside = 0;
  for (const Vector2d& p : inner.points)
    inside += contains(outer.points, p) || aama::distance_to_ring(outer.points, p) <= touching;
  return static_cast<double>(inside) >= .85 * static_cast<double>(inner.points.size());
}

bool is_upright_rectangle(const Ring& ring) {
  const Box box(ring.points);
  return ring.area > .999 * (box.high - box.low).prod();
}

void orient(Ring& ring) {
  ring.area = aama::signed_area(ring.points);
  if (ring.area < 0) {
    std::reverse(ring.points.begin(), ring.points.end());
    std::reverse(ring.bends.begin(), ring.bends.end());
    ring.area = -ring.area;
  }
}

}  // namespace toile::svg
