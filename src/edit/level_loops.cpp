#include "edit/level_loops.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace toile {
namespace {

// The longest part of a closed walk that visits no vertex twice.
VertexLoop simple_cycle(const VertexLoop& walk) {
  VertexLoop longest, stack;
  std::map<int, std::size_t> at;
  const auto take = [&](std::size_t from) {
    if (stack.size() - from > longest.size()) longest.assign(stack.begin() + static_cast<std::ptrdiff_t>(from), stack.end());
  };
  for (const int v : walk) {
    const auto seen = at.find(v);
    if (seen != at.end()) {
      take(seen->second);
      for (std::size_t i = seen->second + 1; i < stack.size(); ++i) at.erase(stack[i]);
      stack.resize(seen->second + 1);
      continue;
    }
    at[v] = stack.size();
    stack.push_back(v);
  }
  take(0);
  return longest;
}

}  // namespace

LevelMesh level_mesh(const Eigen::Matrix3Xi& triangles) {
  LevelMesh mesh{triangles, mesh_edges(triangles), Eigen::Matrix3Xi(3, triangles.cols())};
  for (MeshEdge& edge : mesh.edges)  // a line on a layer that is sewn into a seam of others ends there
    if (const auto side = static_cast<std::size_t>(edge.further); edge.further == 0 || edge.further == 1)
      edge = {edge.vertex, {edge.triangle[side], -1}, {edge.opposite[side], -1}, 0};
  for (std::size_t e = 0; e < mesh.edges.size(); ++e)
    for (const int t : mesh.edges[e].triangle)
      for (int corner = 0; t >= 0 && corner < 3; ++corner) {
        const int a = triangles(corner, t), b = triangles((corner + 1) % 3, t);
        if (std::min(a, b) == mesh.edges[e].vertex[0] && std::max(a, b) == mesh.edges[e].vertex[1])
          mesh.edge_of(corner, t) = static_cast<int>(e);
      }
  return mesh;
}

LevelLoops level_loops(const LevelMesh& mesh, const Eigen::VectorXd& field, double level, LevelSide side) {
  const auto above = [&](int v) { return field(v) >= level; };
  const auto crossed = [&](std::size_t e) { return above(mesh.edges[e].vertex[0]) != above(mesh.edges[e].vertex[1]); };
  const auto chosen_end = [&](std::size_t e) {
    const auto [a, b] = mesh.edges[e].vertex;
    if (side != LevelSide::nearer) return above(a) == (side == LevelSide::after) ? a : b;
    return std::abs(field(a) - level) <= std::abs(field(b) - level) ? a : b;
  };
  LevelLoops found;
  std::vector<bool> done(mesh.edges.size(), false);
  // Follows the line from edge `start` through `triangle` on; true when it comes back.
  const auto follow = [&](std::size_t start, int triangle, VertexLoop& walk) {
    std::size_t edge = start;
    while (triangle >= 0) {
      std::size_t next = edge;
      for (int corner = 0; corner < 3; ++corner) {
        const auto e = static_cast<std::size_t>(mesh.edge_of(corner, triangle));
        if (e != edge && crossed(e)) next = e;
      }
      if (next == start) return true;
      if (next == edge || done[next]) return false;
      edge = next;
      done[edge] = true;
      walk.push_back(chosen_end(edge));
      triangle = mesh.edges[edge].triangle[mesh.edges[edge].triangle[0] == triangle ? 1 : 0];
    }
    return false;
  };
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    if (done[e] || !crossed(e)) continue;
    done[e] = true;
    VertexLoop walk{chosen_end(e)};
    if (follow(e, mesh.edges[e].triangle[0], walk)) {
      VertexLoop loop = simple_cycle(walk);
      if (loop.size() >= 3) found.closed.push_back(std::move(loop));
    } else {
      VertexLoop rest;
      follow(e, mesh.edges[e].triangle[1], rest);
      ++found.open;
    }
  }
  return found;
}

}  // namespace toile
