#pragma once
// Half-edge questions about a triangle list, also where several pieces are sewn into one seam.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace toile {

// An edge with the triangles on its two sides; triangle[1] is -1 on a boundary. vertex[0] < vertex[1]; triangle[0] is the one
// that runs from vertex[0] to vertex[1] unless only the other exists. opposite[i] is the vertex of triangle[i] off the edge.
struct MeshEdge {
  std::array<int, 2> vertex;
  std::array<int, 2> triangle;
  std::array<int, 2> opposite;
  // Where more than two triangles meet, an edge has further entries, after its own, which is -1 here. 2: two more triangles,
  // across from each other; 0 or 1: one more, triangle[further], beside the first across from it, which an earlier entry has.
  int further = -1;
  bool operator==(const MeshEdge&) const = default;
};

// Whether entry `edge` is the first that has the triangle of its side `side`: 0 or 1.
inline bool is_new(const MeshEdge& edge, std::size_t side) {
  return edge.triangle[side] >= 0 && (edge.further == -1 || edge.further == 2 || edge.further == static_cast<int>(side));
}

// Every edge once, sorted by vertex pair; an edge of more than two triangles (several pieces sewn into one seam) several times
// in a row. Those that face one way are paired with those that face the other in the order of their numbers.
std::vector<MeshEdge> mesh_edges(const Eigen::Matrix3Xi& triangles);

// Boundary loops as closed vertex lists without repeated end, each running with the surface on its left (seen from outside),
// starting at its smallest vertex; sorted by that vertex. Where more than two triangles meet at an edge there is no boundary,
// but the boundary of a further layer that ends there (an apron's in the waist seam) goes on along that edge to where it leaves
// it again. Throws std::invalid_argument when an edge has two triangles that face opposite ways.
std::vector<std::vector<int>> boundary_loops(const Eigen::Matrix3Xi& triangles);

// Number of the connected component of each of `vertex_count` vertices (isolated ones get their own).
std::vector<int> components(const Eigen::Matrix3Xi& triangles, int vertex_count);

// What keeps a triangle mesh from being a closed, consistently oriented surface, in words; empty when nothing does.
std::vector<std::string> defects_of_closed_surface(const Eigen::Matrix3Xi& triangles);

}  // namespace toile
