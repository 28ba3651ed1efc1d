#pragma once
// Which part of a garment a loop moves, and along which way.

#include <set>
#include <vector>

#include "body/relative.h"
#include "edit/level_loops.h"
#include "edit/loops.h"

namespace toile {

using VertexNeighbours = std::vector<std::vector<int>>;  // by vertex
VertexNeighbours neighbours_of(const LevelMesh& mesh, Eigen::Index vertex_count);

// Vertices that can be reached along edges from `from` without going through `blocked`, `from` included, ascending.
std::vector<int> reached(const VertexNeighbours& neighbours, const VertexLoop& from, const std::set<int>& blocked);

// Vertices of the seams that several pieces are sewn into.
std::set<int> layered_seams(const LevelMesh& mesh);

// What hangs together with the loop without going through such a seam, ascending; through all, for a loop that touches one.
std::vector<int> layer_of(const VertexNeighbours& neighbours, const VertexLoop& loop, const std::set<int>& seams);

// Where that ends: the seams' vertices beside `part` (ascending) that are not in it.
std::vector<int> edge_of_layer(const VertexNeighbours& neighbours, const std::vector<int>& part, const std::set<int>& seams);

// A vertex of the ring has a neighbour in `part` (ascending).
bool touches(const VertexNeighbours& neighbours, const VertexLoop& ring, const std::vector<int>& part);

// Unit: the way the limb runs that most of the loop belongs to; straight down for limbs that hang nearly so.
Eigen::Vector3d limb_direction(const std::vector<RelativePlace>& places, const VertexLoop& loop);

// The side of a level's plane that is towards `way`; `after` for loops that are not at a level.
LevelSide side_of(const NamedLoops& named, const Eigen::Vector3d& way);

// m, axis coordinate of a loop in the mean, or of the plane that names it.
double level_of(const NamedLoops& named, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                const Eigen::Vector3d& axis);

}  // namespace toile
