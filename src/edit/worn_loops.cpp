#include "edit/worn_loops.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "body/relative.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double beyond_shoulder = 0.12;  // m

// Closed lines between the triangles of some panels and those of the others; lines that end or branch are left out.
std::vector<VertexLoop> lines_between(const GarmentMesh& garment, const std::vector<MeshEdge>& edges,
                                      const std::set<int>& panels) {
  std::vector<bool> in;
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    in.insert(in.end(), static_cast<std::size_t>(garment.panels[p].triangles.cols()), panels.count(static_cast<int>(p)) > 0);
  std::map<int, std::vector<int>> next;
  std::array<int, 2> last{-1, -1};  // where several pieces are sewn into one seam there is one line
  for (const MeshEdge& edge : edges) {
    if (edge.triangle[1] < 0 ||
        in[static_cast<std::size_t>(edge.triangle[0])] == in[static_cast<std::size_t>(edge.triangle[1])])
      continue;
    if (std::exchange(last, edge.vertex) == edge.vertex) continue;
    next[edge.vertex[0]].push_back(edge.vertex[1]);
    next[edge.vertex[1]].push_back(edge.vertex[0]);
  }
  std::vector<VertexLoop> loops;
  std::set<int> done;
  for (const auto& [start, ways] : next) {
    if (done.count(start)) continue;
    VertexLoop loop;
    bool simple = true;
    int from = -1, here = start;
    while (done.insert(here).second) {
      loop.push_back(here);
      const std::vector<int>& on = next.at(here);
      simple = simple && on.size() == 2;
      const int to = on.front() != from || on.size() == 1 ? on.front() : on.back();
      from = here;
      here = to;
    }
    if (simple && here == start && loop.size() >= 3) loops.push_back(std::move(loop));
  }
  return loops;
}

double length_of(const Eigen::Matrix3Xd& positions, const VertexLoop& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (positions.col(loop[i]) - positions.col(loop[(i + 1) % loop.size()])).norm();
  return length;
}

const VertexLoop* longest(const Eigen::Matrix3Xd& positions, const std::vector<VertexLoop>& loops) {
  const auto found = std::max_element(loops.begin(), loops.end(), [&](const VertexLoop& a, const VertexLoop& b) {
    return length_of(positions, a) < length_of(positions, b);
  });
  return found == loops.end() ? nullptr : &*found;
}

// m from the start of the limb, in the mean.
double mean_along(const EditInput& input, const LimbAxis& axis, int limb, const VertexLoop& loop) {
  double sum = 0;
  for (const int v : loop) {
    const RelativePlace place = relative_place(input.body, axis, limb, input.drape.col(v));
    sum += (place.along + place.beyond) / static_cast<double>(loop.size());
  }
  return sum;
}

}  // namespace

std::vector<Armhole> armholes(const EditInput& input) {
  const std::vector<LimbAxis> axes = limb_axes(input.body.form);
  const auto places = relative_places(input.body, input.drape, input.garment.triangles);
  const auto chains = skeleton_chains(input.body.form);
  const std::vector<MeshEdge> edges = mesh_edges(input.garment.triangles);
  const std::vector<VertexLoop> open = boundary_loops(input.garment.triangles);
  std::vector<Armhole> found;
  for (const char* name : {"arm.L", "arm.R"}) {
    const auto axis = std::find_if(axes.begin(), axes.end(), [&](const LimbAxis& a) { return a.name == name; });
    if (axis == axes.end()) continue;
    const auto limb = static_cast<int>(axis - axes.begin());
    std::set<int> sleeve;
    for (std::size_t p = 0; p < input.garment.panels.size(); ++p) {
      const Eigen::VectorXi& welded = input.garment.welded[p];
      const auto on_arm = std::count_if(welded.data(), welded.data() + welded.size(),
                                        [&](int v) { return places[static_cast<std::size_t>(v)].limb == limb; });
      if (2 * on_arm > welded.size()) sleeve.insert(static_cast<int>(p));
    }
    const std::vector<VertexLoop> seams = lines_between(input.garment, edges, sleeve);
    const VertexLoop* best = longest(input.drape, seams);
    double nearest = beyond_shoulder;
    for (const VertexLoop& loop : open) {
      if (!sleeve.empty() || !threading(chains, input.drape, loop).round_one_arm()) continue;
      // Of the other arm when that is nearer.
      const double far = mean_along(input, *axis, limb, loop);
      const bool same_side = std::count_if(loop.begin(), loop.end(), [&](int v) {
                               return (input.drape(0, v) > axis->points.front().x() / 2) == (axis->points.front().x() > 0);
                             }) > static_cast<std::ptrdiff_t>(loop.size() / 2);
      if (!same_side || far > nearest) continue;
      nearest = far;
      best = &loop;
    }
    if (best) found.push_back({name[4] == 'L', *best});
  }
  return found;
}

std::vector<VertexLoop> necklines(const EditInput& input) {
  const auto chains = skeleton_chains(input.body.form);
  const auto round_neck = [&](const VertexLoop& loop) {
    const Threading through = threading(chains, input.drape, loop);
    return through.heads > 0 && through.hands == 0 && through.feet == 0;
  };
  const auto only_round_neck = [&](std::vector<VertexLoop> loops) {
    loops.erase(std::remove_if(loops.begin(), loops.end(), [&](const VertexLoop& loop) { return !round_neck(loop); }),
                loops.end());
    return loops;
  };
  const std::vector<VertexLoop> free = only_round_neck(boundary_loops(input.garment.triangles));
  const VertexLoop* best = longest(input.drape, free);
  if (!best) return {};
  VertexLoop neck = *best;
  // From the free edge on: panels that come to it, as long as what is below them closes round the neck.
  const std::vector<MeshEdge> edges = mesh_edges(input.garment.triangles);
  std::set<int> collar, at_loop(neck.begin(), neck.end());
  while (true) {
    const std::size_t count = collar.size();
    for (std::size_t p = 0; p < input.garment.panels.size(); ++p) {
      const Eigen::VectorXi& welded = input.garment.welded[p];
      if (std::count_if(welded.data(), welded.data() + welded.size(), [&](int v) { return at_loop.count(v) > 0; }) > 1)
        collar.insert(static_cast<int>(p));
    }
    const std::vector<VertexLoop> below = only_round_neck(lines_between(input.garment, edges, collar));
    if (collar.size() == count || below.empty()) return {neck};
    neck = *longest(input.drape, below);
    at_loop = {neck.begin(), neck.end()};
  }
}

}  // namespace toile
