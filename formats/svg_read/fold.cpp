#include "formats/svg_read/fold.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formats/dxf_aama/chains.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

constexpr double beside = 25e-3;  // m, a bracket this far inside its edge
constexpr double parallel = 3 * units::degree;

struct Straight {
  Vector2d from, to;
  bool square = false;  // at both ends
  double length() const { return (to - from).norm(); }
};

double angle(const Vector2d& a, const Vector2d& b) { return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b))); }

double off_line(const Vector2d& p, const Vector2d& from, const Vector2d& to) {
  const Vector2d along = (to - from).normalized();
  return std::abs(along.x() * (p - from).y() - along.y() * (p - from).x());
}

// Straight runs of the ring, vertices that do not bend it passed over; longest first.
std::vector<Straight> straights(const Points<2>& ring) {
  std::vector<Straight> found;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d& before = ring[(i + n - 1) % n];
    if (angle(ring[i] - before, ring[(i + 1) % n] - ring[i]) < .02 * units::degree) continue;
    std::size_t end = i + 1;
    while (end < i + n && off_line(ring[(end + 1) % n], ring[i], ring[end % n]) < 5e-5 &&
           angle(ring[end % n] - ring[i], ring[(end + 1) % n] - ring[end % n]) < units::degree)
      ++end;
    Straight edge{ring[i], ring[end % n]};
    const Vector2d along = edge.to - edge.from;
    const double first = angle(edge.from - before, along), last = angle(along, ring[(end + 1) % n] - edge.to);
    const double right = std::numbers::pi / 2;
    edge.square = std::abs(first - right) < 12 * units::degree && std::abs(last - right) < 12 * units::degree;
    found.push_back(edge);
  }
  std::stable_sort(found.begin(), found.end(), [](const Straight& a, const Straight& b) { return a.length() > b.length(); });
  return found;
}

}  // namespace

std::optional<Fold> drawn_fold(const Ring& outline, const std::vector<const DrawnLine*>& fold_lines) {
  const std::vector<Straight> edges = straights(outline.points);
  for (const DrawnLine* line : fold_lines) {
    const Points<2>& points = line->shape.points;
    // A bracket's ends stand on the fold; otherwise its longest part is beside it.
    std::vector<std::pair<Vector2d, Vector2d>> ways;
    if (!line->shape.closed) ways.push_back({points.front(), points.back()});
    std::pair<Vector2d, Vector2d> longest{points.front(), points.front()};
    for (std::size_t i = 1; i < points.size(); ++i)
      if ((points[i] - points[i - 1]).norm() > (longest.second - longest.first).norm()) longest = {points[i - 1], points[i]};
    ways.push_back(longest);
    const Straight* best = nullptr;
    double best_off = beside;
    for (const auto& [from, to] : ways) {
      if ((to - from).norm() < 1e-3) continue;
      for (const Straight& edge : edges) {
        const double turn = angle(edge.to - edge.from, to - from);
        if (std::min(turn, std::numbers::pi - turn) > parallel) continue;
        const double off = std::max(off_line(from, edge.from, edge.to), off_line(to, edge.from, edge.to));
        const double where = (edge.to - edge.from).normalized().dot((from + to) / 2 - edge.from);
        if (where < 0 || where > edge.length() || off >= best_off - 1e-9) continue;
        best = &edge;
        best_off = off;
      }
      if (best) return Fold{best->from, best->to, true};
    }
  }
  return {};
}

std::optional<Fold> told_fold(const Ring& outline, const std::optional<Points<2>>& cut, const std::optional<Vector2d>& at) {
  std::vector<Straight> edges;
  double longest = 0;
  for (const Straight& edge : straights(outline.points))
    if (edge.square && edge.length() > .03) {
      edges.push_back(edge);
      longest = std::max(longest, edge.length());
    }
  if (cut) {
    std::vector<Straight> net;
    for (const Straight& edge : edges)
      if (aama::distance_to_ring(*cut, (edge.from + edge.to) / 2) < 5e-4) net.push_back(edge);
    if (net.size() == 1) return Fold{net.front().from, net.front().to, false};
  }
  if (at)
    for (const Straight& edge : edges)
      if (edge.length() > .3 * longest && nearest_on<2>({edge.from, edge.to}, *at).distance < beside)
        return Fold{edge.from, edge.to, false};
  const bool by_far = edges.size() == 1 || (edges.size() > 1 && edges[1].length() < .7 * edges[0].length());
  if (by_far) return Fold{edges[0].from, edges[0].to, false};
  return {};
}

}  // namespace toile::svg
