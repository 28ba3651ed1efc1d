#pragma once
// The linear systems of the style energy, with hard constraints eliminated and their factorisations kept.

#include <array>
#include <memory>
#include <utility>
#include <vector>

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

  // The minimiser of sum A (|n^T J|^2 + stiffness_t |B^T J - M_t|^2) + soft terms under the constraints: what iterating solve()
  // with maps that follow the plane maps by all but that stiffness comes to; both by triangle. In balance with `force` (3 x n).
  // Throws as factor() does.
  Eigen::Matrix3Xd solve_directly(const std::vector<SoftTerm>& soft, const std::vector<double>& stiffness,
                                  const std::vector<Eigen::Matrix2d>& maps, const Eigen::Matrix3Xd& force) const;

  // Triangles with a corner that can move, by index.
  const std::vector<std::size_t>& moving() const { return moving_; }

 private:
  // A vertex that can move: x = fixed + frame * y. A vertex with two freedoms has a third unknown that moves nothing.
  struct Mover {
    Eigen::Index vertex = 0;
    Eigen::Matrix3d frame = Eigen::Matrix3d::Identity();
    bool whole = true;  // all three freedoms; the frame is the identity
  };
  void find_movers(const HardConstraints& constraints);
  void find_pairs();
  void find_places(const BlockMatrix& matrix);
  int mover_at(const SourceTriangle& triangle, int corner) const;
  // The matrix of sum (J_t^T entry(t) J_t), entries 3x3 and symmetric; what held corners pull at the others with: `fixed_pull`.
  template <class EntryOf>
  void assemble(const EntryOf& entry, BlockMatrix& matrix, Eigen::Matrix3Xd& fixed_pull) const;
  void add_soft(const std::vector<SoftTerm>& soft, BlockMatrix& matrix) const;
  void pull_soft(const std::vector<SoftTerm>& soft, Eigen::Matrix3Xd& pull) const;
  template <class MapOf>
  void pull_triangles(const MapOf& wanted_map, Eigen::Matrix3Xd& pull) const;
  Eigen::Matrix3Xd solve_for(const Eigen::Matrix3Xd& pull, const BlockMatrix& matrix) const;

  const std::vector<SourceTriangle>& triangles_;
  StyleMemory own_;
  StyleMemory& memory_;
  Eigen::Matrix3Xd fixed_;  // the constrained part of every vertex
  std::vector<Mover> movers_;
  std::vector<int> mover_of_;  // by vertex; -1: held
  std::vector<std::size_t> moving_;
  std::vector<std::pair<int, int>> pairs_;
  std::vector<std::array<int, 9>>
      place_;  // by moving triangle: where a matrix has the block of corners (i, j) at 3 i + j; -1: nowhere
  std::shared_ptr<KeptFactor> harmonic_;
  std::vector<double> laplacian_;  // its values without soft terms
  Eigen::Matrix3Xd fixed_pull_;    // Laplacian times fixed_
  std::vector<SoftTerm> soft_;
};

}  // namespace toile
