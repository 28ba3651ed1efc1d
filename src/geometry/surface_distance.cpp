#include "geometry/surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace toile {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

constexpr Eigen::Index chunk_size = 256;  // fixed, so that neither threads nor their number show in the result

Kernel::Point_3 point(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

void check(const Surface& surface, const char* name) {
  const auto fail = [&](const char* what) {
    throw std::invalid_argument(std::string("surface_distance: ") + name + " " + what);
  };
  if (surface.triangles.cols() == 0) fail("has no triangles");
  if (!surface.positions.allFinite()) fail("has positions that are not finite");
  if (surface.triangles.minCoeff() < 0 || surface.triangles.maxCoeff() >= surface.positions.cols())
    fail("has triangles that name vertices which do not exist");
}

Triangles triangles_of(const Surface& surface, const char* name) {
  Triangles triangles;
  triangles.reserve(static_cast<std::size_t>(surface.triangles.cols()));
  for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
    const Eigen::Vector3d a = surface.positions.col(surface.triangles(0, t));
    const Eigen::Vector3d b = surface.positions.col(surface.triangles(1, t));
    const Eigen::Vector3d c = surface.positions.col(surface.triangles(2, t));
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    // Thinner than this its plane has no reliable direction, and its neighbours share its long sides.
    if ((b - a).cross(c - a).norm() > 1e-12 * longest * longest) triangles.emplace_back(point(a), point(b), point(c));
  }
  if (triangles.empty()) throw std::invalid_argument(std::string("surface_distance: ") + name + " has no area");
  return triangles;
}

// Runs work(chunk) for every chunk on two threads.
template <class Work>
void for_each_chunk(Eigen::Index count, const Work& work) {
  const Eigen::Index chunks = (count + chunk_size - 1) / chunk_size;
  const auto run = [&](Eigen::Index first) {
    for (Eigen::Index chunk = first; chunk < chunks; chunk += 2) work(chunk);
  };
  std::thread other(run, 1);
  run(0);
  other.join();
}

// Nearest points one after the other; each answer bounds the search for the next query, which is close by.
class NearestPoint {
 public:
  NearestPoint(const Tree& tree, const Kernel::Point_3& hint) : tree_(tree), hint_(hint) {}
  double distance(const Eigen::Vector3d& query) {
    const Kernel::Point_3 q = point(query);
    hint_ = tree_.closest_point(q, hint_);
    return std::sqrt(CGAL::squared_distance(q, hint_));
  }

 private:
  const Tree& tree_;
  Kernel::Point_3 hint_;
};

struct OneSided {
  double most = 0, sum = 0, area = 0;
};

// Distances over a lattice of n * n equal triangles; their mean is that of the linear interpolant.
OneSided over_triangle(NearestPoint& nearest, const Eigen::Vector3d& a, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                       double spacing) {
  const int n = std::max(1, static_cast<int>(std::ceil(std::max({u.norm(), v.norm(), (v - u).norm()}) / spacing)));
  OneSided result;
  double weighted = 0;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j) {
      const double distance = nearest.distance(a + (u * i + v * j) / n);
      const int sides = (i == 0) + (j == 0) + (i + j == n);
      weighted += distance * (sides == 0 ? 6 : sides == 1 ? 3 : 1);
      result.most = std::max(result.most, distance);
    }
  result.area = u.cross(v).norm() / 2;
  result.sum = result.area * weighted / (3.0 * n * n);
  return result;
}

OneSided one_sided(const Surface& from, const Tree& to, const Kernel::Point_3& hint, double spacing) {
  const Eigen::Index count = from.triangles.cols();
  std::vector<OneSided> by_chunk(static_cast<std::size_t>((count + chunk_size - 1) / chunk_size));
  for_each_chunk(count, [&](Eigen::Index chunk) {
    OneSided& total = by_chunk[static_cast<std::size_t>(chunk)];
    NearestPoint nearest(to, hint);
    for (Eigen::Index t = chunk * chunk_size; t < std::min(count, (chunk + 1) * chunk_size); ++t) {
      const Eigen::Vector3d a = from.positions.col(from.triangles(0, t));
      const OneSided one = over_triangle(nearest, a, from.positions.col(from.triangles(1, t)) - a,
                                         from.positions.col(from.triangles(2, t)) - a, spacing);
      total = {std::max(total.most, one.most), total.sum + one.sum, total.area + one.area};
    }
  });
  OneSided total;
  for (const OneSided& chunk : by_chunk)
    total = {std::max(total.most, chunk.most), total.sum + chunk.sum, total.area + chunk.area};
  return total;
}

}  // namespace

SurfaceDistance surface_distance(const Surface& a, const Surface& b, double spacing) {
  if (!(spacing > 0)) throw std::invalid_argument("surface_distance: spacing must be positive");
  check(a, "the first surface");
  check(b, "the second surface");
  const Triangles triangles_a = triangles_of(a, "the first surface");
  const Triangles triangles_b = triangles_of(b, "the second surface");
  Tree tree_a(triangles_a.begin(), triangles_a.end());
  Tree tree_b(triangles_b.begin(), triangles_b.end());
  for (Tree* tree : {&tree_a, &tree_b}) {
    tree->do_not_accelerate_distance_queries();
    tree->build();
  }
  const Kernel::Point_3 on_a = triangles_a.front().vertex(0);
  const Kernel::Point_3 on_b = triangles_b.front().vertex(0);

  const OneSided forth = one_sided(a, tree_b, on_b, spacing);
  const OneSided back = one_sided(b, tree_a, on_a, spacing);
  SurfaceDistance result;
  result.a_to_b_max = forth.most;
  result.b_to_a_max = back.most;
  result.hausdorff = std::max(forth.most, back.most);
  result.mean = std::max(forth.sum / forth.area, back.sum / back.area);
  result.a_vertices.resize(a.positions.cols());
  for_each_chunk(a.positions.cols(), [&](Eigen::Index chunk) {
    NearestPoint nearest(tree_b, on_b);
    for (Eigen::Index v = chunk * chunk_size; v < std::min(a.positions.cols(), (chunk + 1) * chunk_size); ++v)
      result.a_vertices(v) = nearest.distance(a.positions.col(v));
  });
  return result;
}

}  // namespace toile
