#include "style/style_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace toile {

StyleSystem::StyleSystem(const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints,
                         Eigen::Index vertex_count, StyleMemory* memory)
    : triangles_(triangles),
      fixed_(Eigen::Matrix3Xd::Zero(3, vertex_count)),
      mover_of_(static_cast<std::size_t>(vertex_count), -1),
      fixed_pull_(Eigen::Matrix3Xd::Zero(3, vertex_count)) {
  find_movers(constraints);
  StyleMemory none;
  assemble_laplacian(memory ? *memory : none);
}

void StyleSystem::find_movers(const HardConstraints& constraints) {
  for (const auto& [vertex, freedom] : constraints.vertices) {
    if (vertex < 0 || vertex >= fixed_.cols())
      throw std::invalid_argument("StyleSystem: constraint on a vertex that is not there");
    fixed_.col(vertex) = freedom.fixed;
  }
  std::vector<bool> in_triangle(mover_of_.size(), false);
  for (const SourceTriangle& triangle : triangles_)
    for (int corner = 0; corner < 3; ++corner) in_triangle[static_cast<std::size_t>(triangle.corners(corner))] = true;
  for (std::size_t v = 0; v < mover_of_.size(); ++v) {
    Mover mover{static_cast<Eigen::Index>(v)};
    const auto constraint = constraints.vertices.find(static_cast<int>(v));
    if (constraint != constraints.vertices.end()) {
      const auto& free = constraint->second.free;
      if (free.cols() == 0) continue;
      mover.frame.setZero();
      mover.frame.leftCols(free.cols()) = free;
    }
    if (!in_triangle[v])
      throw std::invalid_argument("StyleSystem: vertex " + std::to_string(v) + " is in no triangle and not held");
    mover_of_[v] = static_cast<int>(movers_.size());
    movers_.push_back(mover);
  }
}

void StyleSystem::assemble_laplacian(StyleMemory& memory) {
  const auto mover_at = [&](const SourceTriangle& triangle, int corner) {
    return mover_of_[static_cast<std::size_t>(triangle.corners(corner))];
  };
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    bool moves = false;
    for (int i = 0; i < 3; ++i) {
      const int a = mover_at(triangles_[t], i), b = mover_at(triangles_[t], (i + 1) % 3);
      moves = moves || a >= 0;
      if (a >= 0 && b >= 0) pairs.emplace_back(std::min(a, b), std::max(a, b));
    }
    if (moves) moving_.push_back(t);
  }
  if (movers_.empty()) return;
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  matrix_ = memory.matrix(static_cast<int>(movers_.size()), pairs);
  std::fill(matrix_->values().begin(), matrix_->values().end(), 0.0);
  for (const std::size_t t : moving_) {
    const SourceTriangle& triangle = triangles_[t];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double entry = triangle.area * triangle.gradients.row(i).dot(triangle.gradients.row(j));
        fixed_pull_.col(triangle.corners(i)) += entry * fixed_.col(triangle.corners(j));
        const int a = mover_at(triangle, i), b = mover_at(triangle, j);
        if (a < 0 || b < 0 || a < b) continue;
        const Eigen::Matrix3d &to = movers_[static_cast<std::size_t>(a)].frame,
                              &from = movers_[static_cast<std::size_t>(b)].frame;
        Eigen::Matrix3d block = entry * to.transpose() * from;
        for (int k = 0; a == b && k < 3; ++k)
          if (to.col(k).isZero(0)) block(k, k) = entry;
        matrix_->add(a, b, block);
      }
  }
  laplacian_ = matrix_->values();
}

void StyleSystem::factor(std::vector<SoftTerm> soft) {
  soft_ = std::move(soft);
  if (movers_.empty()) return;
  matrix_->values() = laplacian_;
  for (const SoftTerm& term : soft_) {
    const int mover = mover_of_[static_cast<std::size_t>(term.vertex)];
    if (mover < 0) continue;
    const Eigen::Vector3d along = movers_[static_cast<std::size_t>(mover)].frame.transpose() * term.direction;
    matrix_->add(mover, mover, term.weight * along * along.transpose());
  }
  if (!matrix_->factorise() || !(matrix_->pivot_ratio() > 1e-10))
    throw std::invalid_argument("StyleSystem: part of the garment is not constrained");
}

template <class MapOf>
Eigen::Matrix3Xd StyleSystem::solve_for(const MapOf& wanted_map) const {
  Eigen::Matrix3Xd pull = -fixed_pull_;
  for (const std::size_t t : moving_) {
    const SourceTriangle& triangle = triangles_[t];
    const Eigen::Matrix<double, 3, 2> wanted = triangle.area * wanted_map(t);
    for (int corner = 0; corner < 3; ++corner)
      pull.col(triangle.corners(corner)) += wanted * triangle.gradients.row(corner).transpose();
  }
  for (const SoftTerm& term : soft_)
    pull.col(term.vertex) += term.weight * (term.goal - term.direction.dot(fixed_.col(term.vertex))) * term.direction;

  Eigen::Matrix3Xd x = fixed_;
  if (movers_.empty()) return x;
  Eigen::Matrix3Xd right(3, static_cast<Eigen::Index>(movers_.size()));
  for (std::size_t m = 0; m < movers_.size(); ++m)
    right.col(static_cast<Eigen::Index>(m)) = movers_[m].frame.transpose() * pull.col(movers_[m].vertex);
  const Eigen::Matrix3Xd y = matrix_->solve(right);
  for (std::size_t m = 0; m < movers_.size(); ++m)
    x.col(movers_[m].vertex) += movers_[m].frame * y.col(static_cast<Eigen::Index>(m));
  return x;
}

Eigen::Matrix3Xd StyleSystem::solve(const std::vector<Eigen::Matrix2d>& maps) const {
  return solve_for([&](std::size_t t) -> Eigen::Matrix<double, 3, 2> { return triangles_[t].plane * maps[t]; });
}

Eigen::Matrix3Xd StyleSystem::solve_near(const Eigen::Matrix3Xd& guess) const {
  return solve_for([&](std::size_t t) { return map_of(triangles_[t], guess); });
}

}  // namespace toile
