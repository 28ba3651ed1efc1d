#pragma once
// The linear system of one style iteration, with hard constraints eliminated and its factorisation kept.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <vector>

#include "style/hard_constraints.h"
#include "style/soft_terms.h"
#include "style/source_shape.h"

namespace toile {

class StyleSystem {
 public:
  // Keeps references: both arguments must live as long as the system.
  StyleSystem(const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints, Eigen::Index vertex_count);

  // Factors the cotangent Laplacian (kron I3) with these soft terms. Throws std::invalid_argument when a part of the garment is
  // not constrained.
  void factor(std::vector<SoftTerm> soft);

  // The minimiser of shape_energy(maps) + soft terms under the constraints. maps[t] is M_t.
  Eigen::Matrix3Xd solve(const std::vector<Eigen::Matrix2d>& maps) const;
  // The minimiser of sum A |grad(x - guess)|^2 + soft terms under the constraints.
  Eigen::Matrix3Xd solve_near(const Eigen::Matrix3Xd& guess) const;

  // Triangles with a corner that can move, by index.
  const std::vector<std::size_t>& moving() const { return moving_; }
  bool anything_free() const { return freedoms_ > 0; }

 private:
  template <class MapOf>
  Eigen::Matrix3Xd solve_for(const MapOf& wanted_map) const;

  Eigen::Matrix3Xd fixed_;              // the constrained part of every vertex
  std::vector<VertexFreedom> freedom_;  // by vertex
  std::vector<Eigen::Index> first_;     // first unknown of every vertex
  Eigen::Index freedoms_ = 0;
  std::vector<std::size_t> moving_;
  const std::vector<SourceTriangle>& triangles_;
  Eigen::SparseMatrix<double> laplacian_;  // lower triangle, over the unknowns
  Eigen::Matrix3Xd fixed_pull_;            // Laplacian times fixed_
  std::vector<SoftTerm> soft_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower> factor_;
  bool analysed_ = false;
};

}  // namespace toile
