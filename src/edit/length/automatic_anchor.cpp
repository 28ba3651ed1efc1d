#include "edit/length/automatic_anchor.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <utility>

namespace toile {

namespace {

// The first ring at a level that is round the limb.
struct Ring {
  VertexLoop vertices;   // empty: there is none
  bool tight = false;    // lies on the body for at least half its length
  bool at_loop = false;  // has a vertex of the loop
};

}  // namespace

AutomaticAnchor automatic_anchor(const EditInput& input, const LevelMesh& mesh, const ContactRegion& contact,
                                 const VertexLoop& loop, const Eigen::Vector3d& axis, double level,
                                 const std::vector<bool>& connected, double by, EditMemory& memory) {
  constexpr double step = 0.01;
  constexpr int most_missing = 5;    // a gap of that many steps is the end of the limb,
  constexpr double deep_slit = 0.1;  // m
  constexpr int most_slit = 50;      // but a slit before the first ring may be longer
  const double needed = std::max(0.08, by < 0 ? -1.8 * by : 1.5 * by);
  const auto chains = skeleton_chains(input.body.form);
  const Threading own = threading(chains, input.drape, loop);
  const Eigen::VectorXd field = (axis.transpose() * input.drape).transpose();
  const std::set<int> of_loop(loop.begin(), loop.end());
  double nearest = level;
  for (const int v : loop) nearest = std::min(nearest, field(v));
  const double wanted = level - nearest > deep_slit ? level - nearest + needed : needed;  // from the mean level on
  char name[160];
  std::snprintf(name, sizeof name, "ring of loop %d along %.17g %.17g %.17g from %.17g, ", loop.front(), axis.x(), axis.y(),
                axis.z(), level);
  const auto ring_at = [&](double there) {
    for (VertexLoop& vertices : level_loops(mesh, field, there, LevelSide::before).closed) {
      if (!connected[static_cast<std::size_t>(vertices[0])] || !same_limb(own, threading(chains, input.drape, vertices)))
        continue;
      Ring ring{std::move(vertices)};
      ring.tight = tight_share(contact, input.drape, ring.vertices) >= 0.5;
      ring.at_loop = std::any_of(ring.vertices.begin(), ring.vertices.end(), [&](int v) { return of_loop.count(v) > 0; });
      return ring;
    }
    return Ring{};
  };
  AutomaticAnchor found;
  int missing = 0, steps = 0;
  bool any = false;
  for (double above = 2 * step; missing < (any ? most_missing : most_slit); above += step) {
    ++missing;
    const Ring& ring = memory.once(name + std::to_string(steps++), [&] { return ring_at(level - above); });
    if (ring.vertices.empty()) continue;
    missing = 0;
    any = true;
    if (!found.tight_edge && ring.tight) found.tight_edge = level - above;
    if (!ring.at_loop) {
      found.ring = ring.vertices;
      found.level = level - above;
    }
    if (found.tight_edge && above >= wanted && !found.ring.empty()) break;
  }
  return found;
}

}  // namespace toile
