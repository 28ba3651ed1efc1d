#include "edit/length/handle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "edit/level_loops.h"
#include "edit/loops.h"
#include "geometry/topology.h"

namespace toile {
namespace {

const char* const anchor_place = "edit 'length', anchor";

std::vector<std::vector<int>> neighbours_of(const LevelMesh& mesh, Eigen::Index count) {
  std::vector<std::vector<int>> neighbours(static_cast<std::size_t>(count));
  for (const MeshEdge& edge : mesh.edges) {
    neighbours[static_cast<std::size_t>(edge.vertex[0])].push_back(edge.vertex[1]);
    neighbours[static_cast<std::size_t>(edge.vertex[1])].push_back(edge.vertex[0]);
  }
  return neighbours;
}

std::vector<int> reached(const std::vector<std::vector<int>>& neighbours, const VertexLoop& from,
                         const std::set<int>& blocked) {
  std::vector<bool> seen(neighbours.size(), false);
  std::vector<int> stack;
  for (const int v : from)
    if (!blocked.count(v)) stack.push_back(v);
  std::vector<int> found;
  while (!stack.empty()) {
    const int v = stack.back();
    stack.pop_back();
    if (seen[static_cast<std::size_t>(v)]) continue;
    seen[static_cast<std::size_t>(v)] = true;
    found.push_back(v);
    for (const int next : neighbours[static_cast<std::size_t>(v)])
      if (!seen[static_cast<std::size_t>(next)] && !blocked.count(next)) stack.push_back(next);
  }
  std::sort(found.begin(), found.end());
  return found;
}

double mean_level(const Eigen::Matrix3Xd& positions, const VertexLoop& loop, const Eigen::Vector3d& axis) {
  return axis.dot(loop_centre(positions, loop));
}

// The way the limb runs that most of the loop belongs to; straight down for limbs that hang nearly so.
Eigen::Vector3d limb_direction(const std::vector<RelativePlace>& places, const VertexLoop& loop) {
  std::map<int, int> votes;
  for (const int v : loop) ++votes[places[static_cast<std::size_t>(v)].limb];
  const int limb =
      std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const int v : loop)
    if (places[static_cast<std::size_t>(v)].limb == limb) sum += places[static_cast<std::size_t>(v)].axis;
  const Eigen::Vector3d axis = sum.normalized();
  return axis.y() < -std::cos(0.26) ? Eigen::Vector3d(-Eigen::Vector3d::UnitY()) : axis;
}

// Rings round the same limb as the loop (or the trunk, when the loop is round a leg), nearest to the loop first.
class Rings {
 public:
  Rings(const EditInput& input, const LevelMesh& mesh, const Handle& handle, const std::vector<bool>& connected)
      : input_(input), mesh_(mesh), handle_(handle), connected_(connected), chains_(skeleton_chains(input.body.form)) {
    field_ = (handle.axis.transpose() * input.drape).transpose();
    own_ = threading(chains_, input.drape, handle.loop);
  }

  // The ring `above` metres from the loop towards the anchor; empty when there is none.
  VertexLoop at(double above) const {
    for (const VertexLoop& loop : level_loops(mesh_, field_, handle_.level - above).closed)
      if (connected_[static_cast<std::size_t>(loop[0])] && alike(threading(chains_, input_.drape, loop))) return loop;
    return {};
  }

 private:
  static bool round_trunk(const Threading& t) { return t.heads > 0 || t.feet > 1 || t.hands > 1; }
  bool alike(const Threading& ring) const {
    if (ring.nothing()) return false;
    if (own_.nothing() || round_trunk(own_)) return round_trunk(ring) || ring.round_trunk_or_leg();
    return ring.chains == own_.chains || (own_.feet == 1 && round_trunk(ring));
  }

  const EditInput& input_;
  const LevelMesh& mesh_;
  const Handle& handle_;
  const std::vector<bool>& connected_;
  std::vector<SkeletonChain> chains_;
  Eigen::VectorXd field_;
  Threading own_;
};

struct AutomaticAnchor {
  VertexLoop ring;
  std::optional<double> tight_edge;
};

AutomaticAnchor find_anchor(const EditInput& input, const Rings& rings, const Handle& handle, const ContactRegion& contact,
                            double by) {
  constexpr double step = 0.01;
  const double wanted = std::max(0.08, by < 0 ? -2.5 * by : 1.5 * by);
  AutomaticAnchor found;
  int missing = 0;
  for (double above = 2 * step; missing < 5; above += step) {
    VertexLoop ring = rings.at(above);
    missing = ring.empty() ? missing + 1 : 0;
    if (ring.empty()) continue;
    if (!found.tight_edge && tight_share(contact, input.drape, ring) >= 0.5) found.tight_edge = handle.level - above;
    const bool apart = std::none_of(ring.begin(), ring.end(), [&](int v) {
      return std::find(handle.loop.begin(), handle.loop.end(), v) != handle.loop.end();
    });
    if (apart) found.ring = std::move(ring);
    if (found.tight_edge && above >= wanted && apart) break;
  }
  return found;
}

}  // namespace

std::vector<Handle> make_handles(const EditInput& input, const std::vector<VertexLoop>& loops,
                                 const std::vector<RelativePlace>& places, const ContactRegion& contact,
                                 const std::string& anchor, double by) {
  const LevelMesh mesh = level_mesh(input.garment.triangles);
  const auto neighbours = neighbours_of(mesh, input.drape.cols());
  std::vector<bool> on_boundary(neighbours.size(), false);
  for (const MeshEdge& edge : mesh.edges)
    if (edge.triangle[1] < 0)
      for (const int v : edge.vertex) on_boundary[static_cast<std::size_t>(v)] = true;
  const bool automatic = anchor == "auto";
  const std::vector<VertexLoop> named = automatic ? std::vector<VertexLoop>{} : resolve_loops(input, anchor, anchor_place);

  std::vector<Handle> handles;
  for (const VertexLoop& loop : loops) {
    Handle handle;
    handle.loop = loop;
    handle.axis = limb_direction(places, loop);
    const std::vector<int> part = reached(neighbours, loop, {});
    std::vector<bool> connected(neighbours.size(), false);
    double mean = 0;
    for (const int v : part) {
      connected[static_cast<std::size_t>(v)] = true;
      mean += handle.axis.dot(input.drape.col(v)) / static_cast<double>(part.size());
    }
    handle.level = mean_level(input.drape, loop, handle.axis);
    for (const VertexLoop& ring : named)
      if (connected[static_cast<std::size_t>(ring[0])]) handle.anchor.push_back(ring);
    const bool free_edge =
        std::all_of(loop.begin(), loop.end(), [&](int v) { return on_boundary[static_cast<std::size_t>(v)]; });
    double against = mean;
    if (!handle.anchor.empty()) against = mean_level(input.drape, handle.anchor[0], handle.axis);
    if ((free_edge || !automatic) && against > handle.level) {
      handle.axis = -handle.axis;
      handle.level = -handle.level;
    }
    const AutomaticAnchor found = find_anchor(input, Rings(input, mesh, handle, connected), handle, contact, by);
    handle.tight_edge = found.tight_edge;
    if (automatic && !found.ring.empty()) handle.anchor.push_back(found.ring);

    std::set<int> blocked;
    for (const VertexLoop& ring : handle.anchor) blocked.insert(ring.begin(), ring.end());
    handle.moving = reached(neighbours, loop, blocked);
    std::vector<VertexLoop> bounding;
    for (const VertexLoop& ring : handle.anchor) {
      const bool touches = std::any_of(ring.begin(), ring.end(), [&](int v) {
        const auto& next = neighbours[static_cast<std::size_t>(v)];
        return std::any_of(next.begin(), next.end(),
                           [&](int w) { return std::binary_search(handle.moving.begin(), handle.moving.end(), w); });
      });
      if (touches) bounding.push_back(ring);
    }
    handle.anchor = std::move(bounding);
    const bool overlaps = std::any_of(loop.begin(), loop.end(), [&](int v) { return blocked.count(v) > 0; });
    if (handle.anchor.empty() || overlaps)
      throw BadInput({"edit.anchor-elsewhere", Severity::error, anchor_place,
                      automatic ? "no ring of the garment between the loop and the body could serve as anchor"
                                : "'" + anchor + "' does not bound the part of the garment that the loop would move",
                      "name an anchor on the same part of the garment, away from the loop"});

    double nearest_anchor = -1e9, nearest_loop = 1e9;
    for (const VertexLoop& ring : handle.anchor) {
      handle.anchor_level += mean_level(input.drape, ring, handle.axis) / static_cast<double>(handle.anchor.size());
      for (const int v : ring) nearest_anchor = std::max(nearest_anchor, handle.axis.dot(input.drape.col(v)));
    }
    for (const int v : loop) nearest_loop = std::min(nearest_loop, handle.axis.dot(input.drape.col(v)));
    handle.room = nearest_loop - nearest_anchor;
    handles.push_back(std::move(handle));
  }
  return handles;
}

}  // namespace toile
