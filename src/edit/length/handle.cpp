#include "edit/length/handle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "edit/length/automatic_anchor.h"
#include "edit/loops.h"

namespace toile {
namespace {

const char* const loop_place = "edit 'length', loop";
const char* const anchor_place = "edit 'length', anchor";

using Neighbours = std::vector<std::vector<int>>;

Neighbours neighbours_of(const LevelMesh& mesh, Eigen::Index count) {
  Neighbours neighbours(static_cast<std::size_t>(count));
  for (const MeshEdge& edge : mesh.edges) {
    neighbours[static_cast<std::size_t>(edge.vertex[0])].push_back(edge.vertex[1]);
    neighbours[static_cast<std::size_t>(edge.vertex[1])].push_back(edge.vertex[0]);
  }
  return neighbours;
}

std::vector<int> reached(const Neighbours& neighbours, const VertexLoop& from, const std::set<int>& blocked) {
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

bool touches(const Neighbours& neighbours, const VertexLoop& ring, const std::vector<int>& part) {
  return std::any_of(ring.begin(), ring.end(), [&](int v) {
    const auto& next = neighbours[static_cast<std::size_t>(v)];
    return std::any_of(next.begin(), next.end(), [&](int w) { return std::binary_search(part.begin(), part.end(), w); });
  });
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

// The side of a level's plane that is towards `way`, or against it.
LevelSide side_of(const NamedLoops& named, const Eigen::Vector3d& way) {
  return named.level && named.level->normal().dot(way) < 0 ? LevelSide::before : LevelSide::after;
}

// Axis coordinate of a loop in the mean, or of the plane that names it.
double level_of(const NamedLoops& named, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                const Eigen::Vector3d& axis) {
  if (named.level && std::abs(named.level->normal().dot(axis)) > 0.999)
    return -named.level->offset() / named.level->normal().dot(axis);
  return axis.dot(loop_centre(positions, loop));
}

}  // namespace

std::vector<Handle> make_handles(const EditInput& input, const std::string& loop_name, const std::vector<RelativePlace>& places,
                                 const ContactRegion& contact, const std::string& anchor, double by) {
  const LevelMesh mesh = level_mesh(input.garment.triangles);
  const Neighbours neighbours = neighbours_of(mesh, input.drape.cols());
  std::set<int> on_boundary;
  for (const MeshEdge& edge : mesh.edges)
    if (edge.triangle[1] < 0) on_boundary.insert(edge.vertex.begin(), edge.vertex.end());
  const bool automatic = anchor == "auto";
  NamedLoops loops = resolve_loops(input, loop_name, loop_place);
  if (loops.level) {  // the far side of its plane, so that what is before it can be scaled right up to it
    const Eigen::Vector3d way = limb_direction(places, loops.loops.front());
    loops = resolve_loops(input, loop_name, loop_place, side_of(loops, way));
  }

  std::vector<Handle> handles;
  for (const VertexLoop& loop : loops.loops) {
    Handle handle;
    handle.loop = loop;
    handle.axis = limb_direction(places, loop);
    const std::vector<int> part = reached(neighbours, loop, {});
    std::vector<bool> connected(neighbours.size(), false);
    double middle = 0;
    for (const int v : part) {
      connected[static_cast<std::size_t>(v)] = true;
      middle += handle.axis.dot(input.drape.col(v)) / static_cast<double>(part.size());
    }
    const auto on_part = [&](const VertexLoop& ring) { return connected[static_cast<std::size_t>(ring[0])]; };

    NamedLoops named;
    if (!automatic) named = resolve_loops(input, anchor, anchor_place);
    const auto mine = std::find_if(named.loops.begin(), named.loops.end(), on_part);
    const bool free_edge = std::all_of(loop.begin(), loop.end(), [&](int v) { return on_boundary.count(v) > 0; });
    const double here = level_of(loops, input.drape, loop, handle.axis);
    const bool backwards = mine != named.loops.end() ? level_of(named, input.drape, *mine, handle.axis) > here
                                                     : automatic && free_edge && middle > here;
    if (backwards) handle.axis = -handle.axis;
    handle.level = level_of(loops, input.drape, loop, handle.axis);
    if (named.level) named = resolve_loops(input, anchor, anchor_place, side_of(named, -handle.axis));

    const AutomaticAnchor found = automatic_anchor(input, mesh, contact, loop, handle.axis, handle.level, connected, by);
    handle.tight_edge = found.tight_edge;
    if (automatic && !found.ring.empty()) named.loops.push_back(found.ring);

    std::set<int> blocked;
    for (const VertexLoop& ring : named.loops) blocked.insert(ring.begin(), ring.end());
    handle.moving = reached(neighbours, loop, blocked);
    for (const VertexLoop& ring : named.loops)
      if (touches(neighbours, ring, handle.moving)) handle.anchor.push_back(ring);
    const bool overlaps = std::any_of(loop.begin(), loop.end(), [&](int v) { return blocked.count(v) > 0; });
    if (handle.anchor.empty() || overlaps)
      throw BadInput({"edit.anchor-elsewhere", Severity::error, anchor_place,
                      automatic ? "no ring of the garment between the loop and the body could serve as anchor"
                                : "'" + anchor + "' does not bound the part of the garment that the loop would move",
                      "name an anchor on the same part of the garment, away from the loop"});

    double nearest_anchor = -1e9, nearest_loop = 1e9;
    for (const VertexLoop& ring : handle.anchor) {
      handle.anchor_level += level_of(named, input.drape, ring, handle.axis) / static_cast<double>(handle.anchor.size());
      for (const int v : ring) nearest_anchor = std::max(nearest_anchor, handle.axis.dot(input.drape.col(v)));
    }
    if (automatic) handle.anchor_level = found.level;
    for (const int v : loop) nearest_loop = std::min(nearest_loop, handle.axis.dot(input.drape.col(v)));
    handle.room = nearest_loop - nearest_anchor;
    handles.push_back(std::move(handle));
  }
  return handles;
}

}  // namespace toile
