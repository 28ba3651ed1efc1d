#include "formats/dxf_aama/chains.h"

#include <algorithm>
#include <limits>

namespace toile::aama {
namespace {

struct Joint {
  std::size_t run = 0;
  bool reversed = false;
  double distance = std::numeric_limits<double>::infinity();
};

// The unused run whose end is nearest to `at`; of equally near ones the first, and its beginning rather than its end.
// `backwards` asks for runs that lead to `at` instead of away from it.
Joint nearest_joint(const std::vector<Run>& runs, const std::vector<bool>& used, const Eigen::Vector2d& at, bool backwards) {
  Joint best;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (used[i]) continue;
    const Points<2>& points = runs[i].points;
    const double as_drawn = ((backwards ? points.back() : points.front()) - at).norm();
    const double turned = ((backwards ? points.front() : points.back()) - at).norm();
    if (as_drawn < best.distance - 1e-9) best = {i, false, as_drawn};
    if (turned < best.distance - 1e-9) best = {i, true, turned};
  }
  return best;
}

Points<2> directed(const Run& run, bool reversed) {
  Points<2> points = run.points;
  if (reversed) std::reverse(points.begin(), points.end());
  return points;
}

// A line that comes back to where it began, and has been somewhere.
bool ends_meet(const Points<2>& points) {
  if ((points.back() - points.front()).norm() > closing_gap) return false;
  return std::any_of(points.begin(), points.end(),
                     [&](const Eigen::Vector2d& p) { return (p - points.front()).norm() > 4 * closing_gap; });
}

Chain chain_from(std::size_t first, const std::vector<Run>& runs, std::vector<bool>& used) {
  Chain chain;
  chain.line = chain.gap_line = runs[first].line;
  chain.points = runs[first].points;
  used[first] = true;
  int end_line = runs[first].line;
  for (bool backwards : {false, true}) {
    while (!ends_meet(chain.points)) {
      const Eigen::Vector2d end = backwards ? chain.points.front() : chain.points.back();
      const Joint joint = nearest_joint(runs, used, end, backwards);
      if (joint.distance > closing_gap) {
        if (!backwards) {
          const double own = (chain.points.front() - end).norm();
          chain.gap_from = end;
          chain.gap_line = end_line;
          const Points<2>* other = joint.distance < own ? &runs[joint.run].points : nullptr;
          chain.gap_to = other ? (joint.reversed ? other->back() : other->front()) : chain.points.front();
          chain.gap = std::min(joint.distance, own);
        }
        break;
      }
      used[joint.run] = true;
      const Points<2> next = directed(runs[joint.run], joint.reversed);
      if (backwards) {
        chain.points.insert(chain.points.begin(), next.begin(), next.end() - 1);
      } else {
        chain.points.insert(chain.points.end(), next.begin() + 1, next.end());
        end_line = runs[joint.run].line;
      }
    }
    if (ends_meet(chain.points)) break;
  }
  return chain;
}

}  // namespace

Points<2> without_repeats(const Points<2>& points, bool closed) {
  Points<2> kept;
  for (const Eigen::Vector2d& p : points)
    if (kept.empty() || (p - kept.back()).norm() > same_vertex) kept.push_back(p);
  while (closed && kept.size() > 1 && (kept.back() - kept.front()).norm() <= same_vertex) kept.pop_back();
  return kept;
}

std::vector<Chain> chains(const std::vector<Run>& drawn) {
  std::vector<Chain> found;
  std::vector<Run> open;
  for (const Run& run : drawn) {
    const Points<2> points = without_repeats(run.points, run.closed);
    if (points.size() < 2) continue;
    if (run.closed) {
      Chain chain;
      chain.points = points;
      chain.closed = true;
      chain.line = run.line;
      found.push_back(std::move(chain));
    } else {
      open.push_back({points, false, run.line});
    }
  }
  std::vector<bool> used(open.size(), false);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (used[i]) continue;
    Chain chain = chain_from(i, open, used);
    chain.closed = ends_meet(chain.points);
    if (chain.closed) chain.points.pop_back();
    found.push_back(std::move(chain));
  }
  std::stable_sort(found.begin(), found.end(), [](const Chain& a, const Chain& b) { return a.line < b.line; });
  return found;
}

double signed_area(const Points<2>& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Eigen::Vector2d& a = ring[i];
    const Eigen::Vector2d& b = ring[(i + 1) % ring.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

Points<2> closed_polyline(Points<2> ring) {
  if (!ring.empty()) ring.push_back(ring.front());
  return ring;
}

double distance_to_ring(const Points<2>& ring, const Eigen::Vector2d& at) {
  return nearest_on<2>(closed_polyline(ring), at).distance;
}

std::optional<Eigen::Vector2d> crossing(const Points<2>& ring) {
  const std::size_t n = ring.size();
  const auto side = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& p) {
    return (b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x());
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k + 1 == n) continue;  // neighbours
      const Eigen::Vector2d &a = ring[i], &b = ring[i + 1], &c = ring[k], &d = ring[(k + 1) % n];
      const double sc = side(a, b, c), sd = side(a, b, d);
      constexpr double nothing = 1e-9;  // m^2
      const auto opposite = [&](double x, double y) { return (x > nothing && y < -nothing) || (x < -nothing && y > nothing); };
      if (opposite(sc, sd) && opposite(side(c, d, a), side(c, d, b))) return c + sc / (sc - sd) * (d - c);
    }
  return {};
}

}  // namespace toile::aama
