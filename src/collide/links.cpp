#include "collide/links.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace toile {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 point(const Eigen::Vector3d& at) { return {at.x(), at.y(), at.z()}; }

// +1, -1 or 0; points in the plane of the triangle or on lines through its edges count to one side, so that a chain through the
// common edge of two triangles crosses one of them.
int crossing(const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c, const Kernel::Point_3& from,
             const Kernel::Point_3& to) {
  const bool from_above = CGAL::orientation(a, b, c, from) == CGAL::POSITIVE;
  const bool to_above = CGAL::orientation(a, b, c, to) == CGAL::POSITIVE;
  if (from_above == to_above) return 0;
  // An edge has the same sign for both its triangles when its ends are taken in the same order.
  const auto left_of = [&](const Kernel::Point_3& p, const Kernel::Point_3& q) {
    return p < q ? CGAL::orientation(from, to, p, q) == CGAL::POSITIVE : CGAL::orientation(from, to, q, p) != CGAL::POSITIVE;
  };
  const bool ab = left_of(a, b);
  const bool bc = left_of(b, c);
  const bool ca = left_of(c, a);
  if (ab != bc || bc != ca) return 0;
  return from_above ? -1 : 1;
}

}  // namespace

int crossings(const std::vector<Eigen::Vector3d>& loop, const std::vector<Eigen::Vector3d>& chain) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& at : loop) mean += at / static_cast<double>(loop.size());
  int sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    for (std::size_t k = 0; k + 1 < chain.size(); ++k)
      sum += crossing(point(loop[i]), point(loop[(i + 1) % loop.size()]), point(mean), point(chain[k]), point(chain[k + 1]));
  return sum;
}

Eigen::MatrixXi links(const std::vector<std::vector<Eigen::Vector3d>>& loops,
                      const std::vector<std::vector<Eigen::Vector3d>>& chains) {
  Eigen::MatrixXi through(static_cast<Eigen::Index>(loops.size()), static_cast<Eigen::Index>(chains.size()));
  for (std::size_t i = 0; i < loops.size(); ++i)
    for (std::size_t k = 0; k < chains.size(); ++k)
      through(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = crossings(loops[i], chains[k]);
  return through;
}

}  // namespace toile
