#pragma once
// A garment hanging on the body, as a simulator left it.

#include <Eigen/Core>
#include <string>

namespace toile {

struct Drape {
  Eigen::Matrix3Xd positions;  // one column per garment vertex, m
  double residual = 0;         // norm of the unbalanced force / norm of the weight
  int steps = 0;
  bool settled = false;        // residual reached the tolerance asked for
  double max_penetration = 0;  // m, deepest sample inside the body; 0 when outside everywhere
  double slipped = 0;          // m, how far the garment's held part (contact region) dropped from the start
  int inverted_triangles = 0;
  int self_intersections = 0;  // pairs of triangles that pass through each other
  double seconds = 0;
  std::string simulator;
  bool operator==(const Drape&) const = default;
};

}  // namespace toile
