#include "edit/length/handle.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

#include "edit/length/automatic_anchor.h"
#include "edit/loops.h"
#include "edit/reach.h"

namespace toile {
namespace {

const char* const loop_place = "edit 'length', loop";
const char* const anchor_place = "edit 'length', anchor";

}  // namespace

std::vector<Handle> make_handles(const EditInput& input, const std::string& loop_name, const std::string& anchor, double by,
                                 EditMemory& memory) {
  const std::vector<RelativePlace>& places = source_places(input, memory);
  const ContactRegion& contact = source_contact(input, memory);
  const LevelMesh& mesh = garment_edges(input, memory);
  const VertexNeighbours& neighbours = garment_neighbours(input, memory);
  const auto named_loops = [&](const std::string& name, const char* place, LevelSide side) -> const NamedLoops& {
    return memory.once("loops '" + name + "' " + std::to_string(static_cast<int>(side)),
                       [&] { return resolve_loops(input, name, place, side); });
  };
  std::set<int> on_boundary;
  for (const MeshEdge& edge : mesh.edges)
    if (edge.triangle[1] < 0 && edge.further == -1) on_boundary.insert(edge.vertex.begin(), edge.vertex.end());
  const std::set<int> seams = layered_seams(mesh);
  const bool automatic = anchor == "auto";
  NamedLoops loops = named_loops(loop_name, loop_place, LevelSide::nearer);
  if (loops.level) {  // the far side of its plane, so that what is before it can be scaled right up to it
    const Eigen::Vector3d way = limb_direction(places, loops.loops.front());
    loops = named_loops(loop_name, loop_place, side_of(loops, way));
  }

  std::vector<Handle> handles;
  for (const VertexLoop& loop : loops.loops) {
    Handle handle;
    handle.loop = loop;
    handle.axis = limb_direction(places, loop);
    const std::vector<int> part = layer_of(neighbours, loop, automatic ? seams : std::set<int>{});
    std::vector<bool> connected(neighbours.size(), false);
    double middle = 0;
    for (const int v : part) {
      connected[static_cast<std::size_t>(v)] = true;
      middle += handle.axis.dot(input.drape.col(v)) / static_cast<double>(part.size());
    }
    const auto on_part = [&](const VertexLoop& ring) { return connected[static_cast<std::size_t>(ring[0])]; };

    NamedLoops named;
    if (!automatic) named = named_loops(anchor, anchor_place, LevelSide::nearer);
    const auto mine = std::find_if(named.loops.begin(), named.loops.end(), on_part);
    const bool free_edge = std::all_of(loop.begin(), loop.end(), [&](int v) { return on_boundary.count(v) > 0; });
    const double here = level_of(loops, input.drape, loop, handle.axis);
    const bool backwards = mine != named.loops.end() ? level_of(named, input.drape, *mine, handle.axis) > here
                                                     : automatic && free_edge && middle > here;
    if (backwards) handle.axis = -handle.axis;
    handle.level = level_of(loops, input.drape, loop, handle.axis);
    if (named.level) named = named_loops(anchor, anchor_place, side_of(named, -handle.axis));

    const AutomaticAnchor found =
        automatic_anchor(input, mesh, contact, loop, handle.axis, handle.level, connected, by, memory);
    handle.tight_edge = found.tight_edge;
    if (automatic && !found.ring.empty()) named.loops.push_back(found.ring);
    // An overskirt is altered by itself: as far as the seam it hangs from.
    const std::vector<int> seam = automatic ? edge_of_layer(neighbours, part, seams) : std::vector<int>{};
    const bool from_seam = automatic && found.ring.empty() && !seam.empty();
    if (from_seam) named.loops.push_back(seam);

    std::set<int> blocked;
    for (const VertexLoop& ring : named.loops) blocked.insert(ring.begin(), ring.end());
    blocked.insert(seam.begin(), seam.end());
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
    if (automatic && !from_seam) handle.anchor_level = found.level;
    for (const int v : loop) nearest_loop = std::min(nearest_loop, handle.axis.dot(input.drape.col(v)));
    handle.room = nearest_loop - nearest_anchor;
    handles.push_back(std::move(handle));
  }
  return handles;
}

}  // namespace toile
