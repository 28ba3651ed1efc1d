#pragma once
// Lines across a garment's triangles along which it is to be parted.

#include <Eigen/Core>
#include <vector>

#include "edit/skeleton_chains.h"

namespace toile {

// Where a line crosses a mesh edge, and the triangle that it goes on into.
struct Crossing {
  int before = 0, beyond = 0;  // garment vertices: the end of the edge on either side of the line
  double at = 0;               // 0 at `before`, 1 at `beyond`
  int triangle = 0;
};

using CutLine = std::vector<Crossing>;  // closed

// The closed lines where `field` (by vertex) changes from negative to not negative. Those that end at the garment's boundary
// are left out.
std::vector<CutLine> cut_lines(const Eigen::Matrix3Xi& triangles, const Eigen::VectorXd& field);

std::vector<Eigen::Vector3d> points_of(const CutLine& line, const Eigen::Matrix3Xd& positions);
std::vector<Eigen::Vector3d> points_of(const VertexLoop& loop, const Eigen::Matrix3Xd& positions);

// One loop that a garment is parted along: edges of its panels, or a line across them.
struct CutLoop {
  VertexLoop seam;  // closed; empty: `line`
  CutLine line;
};
std::vector<Eigen::Vector3d> points_of(const CutLoop& loop, const Eigen::Matrix3Xd& positions);

}  // namespace toile
