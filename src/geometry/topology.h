#pragma once
// Half-edge questions about a triangle list (OpenMesh behind it).

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

namespace toile {

// An edge with the triangles on its two sides; triangle[1] is -1 on a boundary. vertex[0] < vertex[1]; triangle[0] is the one
// that runs from vertex[0] to vertex[1] unless only the other exists. opposite[i] is the vertex of triangle[i] off the edge.
struct MeshEdge {
  std::array<int, 2> vertex;
  std::array<int, 2> triangle;
  std::array<int, 2> opposite;
  bool operator==(const MeshEdge&) const = default;
};

// Every edge once, sorted by vertex pair. Throws std::invalid_argument when an edge has more than two triangles.
std::vector<MeshEdge> mesh_edges(const Eigen::Matrix3Xi& triangles);

// Boundary loops as closed vertex lists without repeated end, each running with the surface on its left (seen from outside),
// starting at its smallest vertex; sorted by that vertex.
std::vector<std::vector<int>> boundary_loops(const Eigen::Matrix3Xi& triangles);

// Number of the connected component of each of `vertex_count` vertices (isolated ones get their own).
std::vector<int> components(const Eigen::Matrix3Xi& triangles, int vertex_count);

// What keeps a triangle mesh from being a closed, consistently oriented surface, in words; empty when nothing does.
std::vector<std::string> defects_of_closed_surface(const Eigen::Matrix3Xi& triangles);

}  // namespace toile
