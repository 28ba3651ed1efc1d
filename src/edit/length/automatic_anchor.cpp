#include "edit/length/automatic_anchor.h"

#include <algorithm>
#include <set>

namespace toile {

AutomaticAnchor automatic_anchor(const EditInput& input, const LevelMesh& mesh, const ContactRegion& contact,
                                 const VertexLoop& loop, const Eigen::Vector3d& axis, double level,
                                 const std::vector<bool>& connected, double by) {
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
  AutomaticAnchor found;
  int missing = 0;
  bool any = false;
  for (double above = 2 * step; missing < (any ? most_missing : most_slit); above += step) {
    ++missing;
    for (VertexLoop& ring : level_loops(mesh, field, level - above, LevelSide::before).closed) {
      if (!connected[static_cast<std::size_t>(ring[0])] || !same_limb(own, threading(chains, input.drape, ring))) continue;
      missing = 0;
      any = true;
      if (!found.tight_edge && tight_share(contact, input.drape, ring) >= 0.5) found.tight_edge = level - above;
      if (std::any_of(ring.begin(), ring.end(), [&](int v) { return of_loop.count(v) > 0; })) break;
      found.ring = std::move(ring);
      found.level = level - above;
      break;
    }
    if (missing == 0 && found.tight_edge && above >= wanted && !found.ring.empty()) break;
  }
  return found;
}

}  // namespace toile
