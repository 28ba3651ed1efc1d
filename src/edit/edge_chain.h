#pragma once
// Named edges of the pattern as closed loops of garment vertices.

#include <string>
#include <vector>

#include "edit/skeleton_chains.h"
#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

struct PanelEdge {
  int panel = 0;  // index into GarmentMesh::panels
  int edge = 0;   // index into Piece::outline
};

// The edges that `name` means: "hem" (every edge with that id), "gore.hem" (of every copy of that piece), "gore:3.hem" (of that
// panel). Empty when there is none.
std::vector<PanelEdge> edges_named(const Pattern& pattern, const GarmentMesh& garment, const std::string& name);

// Garment vertices along an edge, both ends included, in outline order.
std::vector<int> vertices_along(const Pattern& pattern, const GarmentMesh& garment, const PanelEdge& edge);

// Closed loops, each starting at its smallest vertex, sorted by it. A slit between two ends (.8 m of free edge at most) belongs
// to the loop. Throws BadInput("edit.open-chain") naming where the edges leave a gap or branch; `place` and `name` are for the
// message.
std::vector<VertexLoop> closed_chains(const Pattern& pattern, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions,
                                      const std::vector<PanelEdge>& edges, const std::string& place, const std::string& name);

}  // namespace toile
