#include "edit/skeleton_chains.h"

#include <Eigen/Dense>
#include <algorithm>

namespace toile {
namespace {

// +1 or -1 when the segment passes through the triangle from its back or its front, 0 when it misses.
int pass(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& from,
         const Eigen::Vector3d& to) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double before = normal.dot(from - a), after = normal.dot(to - a);
  if ((before < 0) == (after < 0)) return 0;
  const Eigen::Vector3d way = to - from;
  const auto side = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) { return way.dot((p - from).cross(q - from)) < 0; };
  const bool first = side(a, b);
  if (side(b, c) != first || side(c, a) != first) return 0;
  return after > before ? 1 : -1;
}

std::vector<SkeletonChain> upright_axis(const Mannequin& form) {
  Eigen::Vector3d middle = form.positions.cols() ? Eigen::Vector3d(form.positions.rowwise().mean()) : Eigen::Vector3d::Zero();
  const double height = form.positions.cols() ? form.positions.row(1).maxCoeff() : form.height;
  const Eigen::Vector3d top(middle.x(), 2 * height, middle.z()), bottom(middle.x(), -height, middle.z());
  middle.y() = 0.5 * height;
  return {{ChainEnd::head, {middle, top}}, {ChainEnd::foot, {middle, bottom}}};
}

}  // namespace

std::vector<SkeletonChain> skeleton_chains(const Mannequin& form) {
  if (form.bones.empty()) return upright_axis(form);
  double lowest = form.bones.front().to.y(), highest = lowest;
  for (const Bone& bone : form.bones) {
    lowest = std::min({lowest, bone.from.y(), bone.to.y()});
    highest = std::max({highest, bone.from.y(), bone.to.y()});
  }
  std::vector<SkeletonChain> chains;
  for (const Bone& leaf : form.bones) {
    const bool ends = std::none_of(form.bones.begin(), form.bones.end(), [&](const Bone& b) { return b.parent == leaf.name; });
    if (!ends) continue;
    SkeletonChain chain;
    const Bone* bone = &leaf;
    for (std::size_t steps = 0; bone && steps <= form.bones.size(); ++steps) {
      chain.path.push_back(bone->to);
      chain.path.push_back(bone->from);
      bone = find_bone(form, bone->parent);
    }
    std::reverse(chain.path.begin(), chain.path.end());
    const double share = (leaf.to.y() - lowest) / std::max(1e-9, highest - lowest);
    chain.end = share < 0.25 ? ChainEnd::foot : share > 0.85 ? ChainEnd::head : ChainEnd::hand;
    const Eigen::Vector3d onwards = chain.end == ChainEnd::foot   ? Eigen::Vector3d(-Eigen::Vector3d::UnitY())
                                    : chain.end == ChainEnd::head ? Eigen::Vector3d(Eigen::Vector3d::UnitY())
                                                                  : Eigen::Vector3d((leaf.to - leaf.from).normalized());
    chain.path.push_back(leaf.to + (highest - lowest) * onwards);
    chains.push_back(std::move(chain));
  }
  return chains;
}

int crossings(const Eigen::Matrix3Xd& positions, const VertexLoop& loop, const Eigen::Vector3d& from,
              const Eigen::Vector3d& to) {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (const int v : loop) centre += positions.col(v);
  centre /= static_cast<double>(std::max<std::size_t>(1, loop.size()));
  int count = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    count += pass(centre, positions.col(loop[i]), positions.col(loop[(i + 1) % loop.size()]), from, to);
  return count;
}

Threading threading(const std::vector<SkeletonChain>& chains, const Eigen::Matrix3Xd& positions, const VertexLoop& loop) {
  Threading found;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    int count = 0;
    Eigen::Vector3d along = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i + 1 < chains[c].path.size(); ++i) {
      const int here = crossings(positions, loop, chains[c].path[i], chains[c].path[i + 1]);
      if (here != 0) along = (chains[c].path[i + 1] - chains[c].path[i]).normalized();
      count += here;
    }
    if (count == 0) continue;
    if (found.chains.empty()) found.along = along;
    found.chains.insert(static_cast<int>(c));
    ++(chains[c].end == ChainEnd::head ? found.heads : chains[c].end == ChainEnd::hand ? found.hands : found.feet);
  }
  return found;
}

bool round_trunk(const Threading& ring) { return ring.heads > 0 || ring.feet > 1 || ring.hands > 1; }

bool same_limb(const Threading& loop, const Threading& ring) {
  if (ring.nothing()) return false;
  if (loop.nothing() || round_trunk(loop)) return ring.round_trunk_or_leg();
  return ring.chains == loop.chains || (loop.feet == 1 && round_trunk(ring));
}

}  // namespace toile
