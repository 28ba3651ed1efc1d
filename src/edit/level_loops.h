#pragma once
// Closed loops of mesh edges near where a field over the vertices takes a value.

#include <Eigen/Core>
#include <vector>

#include "edit/skeleton_chains.h"
#include "geometry/topology.h"

namespace toile {

// Edges and the three edges of every triangle, made once for many levels. Where several pieces are sewn into one seam a layer
// that nothing goes on from across it has an edge of its own, with one triangle and `further` 0.
struct LevelMesh {
  const Eigen::Matrix3Xi& triangles;
  std::vector<MeshEdge> edges;
  Eigen::Matrix3Xi edge_of;  // [corner][triangle]: the edge from that corner to the next
};
LevelMesh level_mesh(const Eigen::Matrix3Xi& triangles);

struct LevelLoops {
  std::vector<VertexLoop> closed;  // no vertex twice; taking the vertices of all of them away parts above from below
  int open = 0;                    // lines that end at the garment's boundary
};

// Which end of an edge that the level line crosses: the nearer one (at most half an edge off), or the one before or after it.
enum class LevelSide { nearer, before, after };

LevelLoops level_loops(const LevelMesh& mesh, const Eigen::VectorXd& field, double level, LevelSide side = LevelSide::nearer);

}  // namespace toile
