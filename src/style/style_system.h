#pragma once
// The linear system of one style iteration, with hard constraints eliminated and its factorisation kept.

#include <memory>
#include <vector>

#include "sparse/block_matrix.h"
#include "style/hard_constraints.h"
#include "style/soft_terms.h"
#include "style/source_shape.h"
#include "style/style_memory.h"

namespace toile {

class StyleSystem {
 public:
  // Keeps a reference to `triangles`. `memory` of earlier systems saves work.
  StyleSystem(const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints, Eigen::Index vertex_count,
              StyleMemory* memory = nullptr);

  // Factors the cotangent Laplacian (kron I3) with these soft terms. Throws std::invalid_argument when a part of the garment is
  // not constrained.
  void factor(std::vector<SoftTerm> soft);

  // The minimiser of shape_energy(maps) + soft terms under the constraints. maps[t] is M_t.
  Eigen::Matrix3Xd solve(const std::vector<Eigen::Matrix2d>& maps) const;
  // The minimiser of sum A |grad(x - guess)|^2 + soft terms under the constraints.
  Eigen::Matrix3Xd solve_near(const Eigen::Matrix3Xd& guess) const;

  // Triangles with a corner that can move, by index.
  const std::vector<std::size_t>& moving() const { return moving_; }

 private:
  // A vertex that can move: x = fixed + frame * y. A vertex with two freedoms has a third unknown that moves nothing.
  struct Mover {
    Eigen::Index vertex = 0;
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
  };
  template <class MapOf>
  Eigen::Matrix3Xd solve_for(const MapOf& wanted_map) const;
  void find_movers(const HardConstraints& constraints);
  void assemble_laplacian(StyleMemory& memory);

  const std::vector<SourceTriangle>& triangles_;
  Eigen::Matrix3Xd fixed_;  // the constrained part of every vertex
  std::vector<Mover> movers_;
  std::vector<int> mover_of_;  // by vertex; -1: held
  std::vector<std::size_t> moving_;
  Eigen::Matrix3Xd fixed_pull_;  // Laplacian times fixed_
  std::vector<SoftTerm> soft_;
  std::shared_ptr<BlockMatrix> matrix_;
  std::vector<double> laplacian_;  // its values without soft terms
};

}  // namespace toile
