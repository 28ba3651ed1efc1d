#include "formats/svg_read/inset.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/chains.h"
#include "formats/svg_read/details.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

Vector2d left_of(const Vector2d& way) { return Vector2d(-way.y(), way.x()).normalized(); }

// `edge` moved to its left, each vertex along the bisector.
Points<2> moved(const Points<2>& edge, double width) {
  Points<2> line;
  for (std::size_t i = 0; i < edge.size(); ++i) {
    const Vector2d before = i > 0 ? left_of(edge[i] - edge[i - 1]) : left_of(edge[1] - edge[0]);
    const Vector2d after = i + 1 < edge.size() ? left_of(edge[i + 1] - edge[i]) : before;
    const Vector2d middle = (before + after).normalized();
    line.push_back(edge[i] + width / std::max(.3, middle.dot(after)) * middle);
  }
  return line;
}

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Joins the end of `a` to the beginning of `b` where they meet, or where their last parts, carried on, would.
void meet(Points<2>& a, Points<2>& b, double width) {
  for (std::size_t i = a.size() - 1; i > 0; --i)
    for (std::size_t k = 1; k < b.size(); ++k) {
      const Vector2d d = a[i] - a[i - 1], e = b[k] - b[k - 1], to = b[k - 1] - a[i - 1];
      const double across = cross(d, e);
      if (std::abs(across) < 1e-15) continue;
      const double t = cross(to, e) / across, u = cross(to, d) / across;
      if (t < 0 || t > 1 || u < 0 || u > 1) continue;
      const Vector2d at = a[i - 1] + t * d;
      a.resize(i);
      a.push_back(at);
      b.erase(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(k));
      b.insert(b.begin(), at);
      return;
    }
  const Vector2d d = a.back() - a[a.size() - 2], e = b[1] - b.front();
  const double across = cross(d.normalized(), e.normalized());
  Vector2d at = (a.back() + b.front()) / 2;
  if (std::abs(across) > .05) {
    const Vector2d hit = a.back() + cross(b.front() - a.back(), e) / cross(d, e) * d;
    if ((hit - at).norm() < 6 * width) at = hit;
  }
  a.push_back(at);
  b.insert(b.begin(), at);
}

}  // namespace

std::optional<Ring> inset(const Ring& cut, double width) {
  const std::vector<bool> corner = corners_of(cut);
  const std::size_t n = cut.points.size();
  const auto first = static_cast<std::size_t>(std::find(corner.begin(), corner.end(), true) - corner.begin());
  std::vector<Points<2>> edges;
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (k > 0) edges.back().push_back(cut.points[i]);
    if (k < n && (k == 0 || corner[i])) edges.push_back({cut.points[i]});
  }
  for (Points<2>& edge : edges) edge = moved(edge, width);
  if (edges.size() > 1)
    for (std::size_t i = 0; i < edges.size(); ++i) meet(edges[i], edges[(i + 1) % edges.size()], width);
  Ring net;
  net.role = Role::sew;
  net.lines = cut.lines;
  net.line = cut.line;
  for (const Points<2>& edge : edges)
    for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
      net.points.push_back(edge[i]);
      net.bends.push_back(i == 0 && edges.size() > 1 ? Bend::corner : Bend::smooth);
    }
  net.area = aama::signed_area(net.points);
  if (net.points.size() < 3 || net.area <= 0 || net.area >= cut.area || aama::crossing(net.points)) return {};
  for (const Vector2d& p : net.points)
    if (!contains(cut.points, p) || aama::distance_to_ring(cut.points, p) < width - .3e-3) return {};
  return net;
}

}  // namespace toile::svg
