#include "formats/dxf_aama/bridge.h"

#include <algorithm>
#include <cmath>

namespace toile::aama {
namespace {

// A part and where on the cut line, by arc length fraction, it leaves and comes back.
struct Placed {
  double begin = 0, end = 0;
  Points<2> points;
};

double ahead(double from, double to) { return to >= from ? to - from : to - from + 1; }

// The closed line `loop` from one fraction forwards to another, over its start if need be; both ends included.
Points<2> forwards(const Points<2>& loop, double from, double to) {
  if (to >= from) return part_of<2>(loop, from, to);
  Points<2> points = part_of<2>(loop, from, 1);
  const Points<2> rest = part_of<2>(loop, 0, to);
  points.insert(points.end(), rest.begin() + 1, rest.end());
  return points;
}

}  // namespace

std::optional<Points<2>> bridged(const std::vector<Chain>& parts, const Points<2>& cut) {
  const Points<2> loop = closed_polyline(cut);
  const double around = polyline_length<2>(loop);
  std::vector<Placed> placed;
  for (const Chain& part : parts) {
    if (part.closed) continue;
    const PolylinePlace begin = nearest_on<2>(loop, part.points.front());
    const PolylinePlace end = nearest_on<2>(loop, part.points.back());
    if (begin.distance > closing_gap || end.distance > closing_gap) return {};
    Placed place{begin.at, end.at, part.points};
    // It follows the cut line in the direction in which it is about as long as it.
    const double share = polyline_length<2>(part.points) / around;
    if (std::abs(ahead(end.at, begin.at) - share) < std::abs(ahead(begin.at, end.at) - share)) {
      std::swap(place.begin, place.end);
      std::reverse(place.points.begin(), place.points.end());
    }
    placed.push_back(std::move(place));
  }
  if (placed.empty()) return {};
  const double start = placed.front().begin;
  std::sort(placed.begin(), placed.end(),
            [&](const Placed& a, const Placed& b) { return ahead(start, a.begin) < ahead(start, b.begin); });

  Points<2> ring;
  double covered = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const double next = placed[(i + 1) % placed.size()].begin;
    covered += ahead(placed[i].begin, placed[i].end);
    ring.insert(ring.end(), placed[i].points.begin(), placed[i].points.end());
    const double gap = ahead(placed[i].end, next);
    if (gap * around <= closing_gap || (1 - gap) * around <= closing_gap) continue;
    covered += gap;
    const Points<2> bridge = forwards(loop, placed[i].end, next);
    ring.insert(ring.end(), bridge.begin() + 1, bridge.end() - 1);
  }
  if (covered > 1 + 4 * closing_gap / around) return {};  // parts overlap
  return without_repeats(ring, true);
}

}  // namespace toile::aama
