#include "edit/reach.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace toile {

VertexNeighbours neighbours_of(const LevelMesh& mesh, Eigen::Index count) {
  VertexNeighbours neighbours(static_cast<std::size_t>(count));
  std::array<int, 2> last{-1, -1};
  for (const MeshEdge& edge : mesh.edges) {
    if (std::exchange(last, edge.vertex) == edge.vertex) continue;
    neighbours[static_cast<std::size_t>(edge.vertex[0])].push_back(edge.vertex[1]);
    neighbours[static_cast<std::size_t>(edge.vertex[1])].push_back(edge.vertex[0]);
  }
  return neighbours;
}

std::vector<int> reached(const VertexNeighbours& neighbours, const VertexLoop& from, const std::set<int>& blocked) {
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

std::set<int> layered_seams(const LevelMesh& mesh) {
  std::set<int> seams;
  for (const MeshEdge& edge : mesh.edges)
    if (edge.further != -1) seams.insert(edge.vertex.begin(), edge.vertex.end());
  return seams;
}

std::vector<int> layer_of(const VertexNeighbours& neighbours, const VertexLoop& loop, const std::set<int>& seams) {
  const bool touching = std::any_of(loop.begin(), loop.end(), [&](int v) { return seams.count(v) > 0; });
  return reached(neighbours, loop, touching ? std::set<int>{} : seams);
}

std::vector<int> edge_of_layer(const VertexNeighbours& neighbours, const std::vector<int>& part, const std::set<int>& seams) {
  const auto in_part = [&](int v) { return std::binary_search(part.begin(), part.end(), v); };
  std::vector<int> edge;
  for (const int v : seams) {
    const auto& next = neighbours[static_cast<std::size_t>(v)];
    if (!in_part(v) && std::any_of(next.begin(), next.end(), in_part)) edge.push_back(v);
  }
  return edge;
}

bool touches(const VertexNeighbours& neighbours, const VertexLoop& ring, const std::vector<int>& part) {
  return std::any_of(ring.begin(), ring.end(), [&](int v) {
    const auto& next = neighbours[static_cast<std::size_t>(v)];
    return std::any_of(next.begin(), next.end(), [&](int w) { return std::binary_search(part.begin(), part.end(), w); });
  });
}

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

LevelSide side_of(const NamedLoops& named, const Eigen::Vector3d& way) {
  return named.level && named.level->normal().dot(way) < 0 ? LevelSide::before : LevelSide::after;
}

double level_of(const NamedLoops& named, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                const Eigen::Vector3d& axis) {
  if (named.level && std::abs(named.level->normal().dot(axis)) > 0.999)
    return -named.level->offset() / named.level->normal().dot(axis);
  return axis.dot(loop_centre(positions, loop));
}

}  // namespace toile
