#include "style/style_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <stdexcept>
#include <string>

namespace toile {
namespace {

void require(bool factorised) {
  if (!factorised) throw std::invalid_argument("StyleSystem: part of the garment is not constrained");
}

}  // namespace

StyleSystem::StyleSystem(const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints,
                         Eigen::Index vertex_count, StyleMemory* memory)
    : triangles_(triangles),
      memory_(memory ? *memory : own_),
      fixed_(Eigen::Matrix3Xd::Zero(3, vertex_count)),
      mover_of_(static_cast<std::size_t>(vertex_count), -1),
      fixed_pull_(Eigen::Matrix3Xd::Zero(3, vertex_count)) {
  find_movers(constraints);
  find_pairs();
  if (movers_.empty()) return;
  harmonic_ = memory_.factor(StyleMemory::Use::harmonic, static_cast<int>(movers_.size()), pairs_);
  find_places(harmonic_->matrix());
  assemble([&](std::size_t t) -> Eigen::Matrix3d { return triangles_[t].area * Eigen::Matrix3d::Identity(); },
           harmonic_->fill(), fixed_pull_);
  laplacian_ = harmonic_->matrix().values();
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
    Mover mover;
    mover.vertex = static_cast<Eigen::Index>(v);
    const auto constraint = constraints.vertices.find(static_cast<int>(v));
    if (constraint != constraints.vertices.end()) {
      const auto& free = constraint->second.free;
      if (free.cols() == 0) continue;
      mover.frame.setZero();
      mover.frame.leftCols(free.cols()) = free;
      mover.whole = false;
    }
    if (!in_triangle[v])
      throw std::invalid_argument("StyleSystem: vertex " + std::to_string(v) + " is in no triangle and not held");
    mover_of_[v] = static_cast<int>(movers_.size());
    movers_.push_back(mover);
  }
}

int StyleSystem::mover_at(const SourceTriangle& triangle, int corner) const {
  return mover_of_[static_cast<std::size_t>(triangle.corners(corner))];
}

void StyleSystem::find_pairs() {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    bool moves = false;
    for (int i = 0; i < 3; ++i) {
      const int a = mover_at(triangles_[t], i), b = mover_at(triangles_[t], (i + 1) % 3);
      moves = moves || a >= 0;
      if (a >= 0 && b >= 0) pairs_.emplace_back(std::min(a, b), std::max(a, b));
    }
    if (moves) moving_.push_back(t);
  }
  std::sort(pairs_.begin(), pairs_.end());
  pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
}

void StyleSystem::find_places(const BlockMatrix& matrix) {
  for (const std::size_t t : moving_) {
    std::array<int, 9> place;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int a = mover_at(triangles_[t], i), b = mover_at(triangles_[t], j);
        place[static_cast<std::size_t>(3 * i + j)] = b < 0 || a < b ? -1 : matrix.place(a, b);
      }
    place_.push_back(place);
  }
}

template <class EntryOf>
void StyleSystem::assemble(const EntryOf& entry_of, BlockMatrix& matrix, Eigen::Matrix3Xd& fixed_pull) const {
  std::fill(matrix.values().begin(), matrix.values().end(), 0.0);
  for (std::size_t m = 0; m < moving_.size(); ++m) {
    const SourceTriangle& triangle = triangles_[moving_[m]];
    const auto entry = entry_of(moving_[m]);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int a = mover_at(triangle, i);
        const double weight = triangle.gradients.row(i).dot(triangle.gradients.row(j));
        if (a >= 0) fixed_pull.col(triangle.corners(i)) += weight * (entry * fixed_.col(triangle.corners(j)));
        const int place = place_[m][static_cast<std::size_t>(3 * i + j)];
        if (place < 0) continue;
        Eigen::Map<Eigen::Matrix3d> into(&matrix.values()[static_cast<std::size_t>(place)]);
        const Mover &to = movers_[static_cast<std::size_t>(a)],
                    &from = movers_[static_cast<std::size_t>(mover_at(triangle, j))];
        if (to.whole && from.whole) {
          into += weight * entry;
          continue;
        }
        into += weight * (to.frame.transpose() * entry * from.frame);
        for (int k = 0; i == j && k < 3; ++k)
          if (to.frame.col(k).isZero(0)) into(k, k) += weight * entry.trace() / 3;
      }
  }
}

void StyleSystem::add_soft(const std::vector<SoftTerm>& soft, BlockMatrix& matrix) const {
  for (const SoftTerm& term : soft) {
    const int mover = mover_of_[static_cast<std::size_t>(term.vertex)];
    if (mover < 0) continue;
    const Eigen::Vector3d along = movers_[static_cast<std::size_t>(mover)].frame.transpose() * term.direction;
    matrix.add(mover, mover, term.weight * along * along.transpose());
  }
}

void StyleSystem::factor(std::vector<SoftTerm> soft) {
  soft_ = std::move(soft);
  if (movers_.empty()) return;
  harmonic_->fill().values() = laplacian_;
  add_soft(soft_, harmonic_->fill());
  require(harmonic_->factorise());
}

template <class MapOf>
void StyleSystem::pull_triangles(const MapOf& wanted_map, Eigen::Matrix3Xd& pull) const {
  for (const std::size_t t : moving_) {
    const SourceTriangle& triangle = triangles_[t];
    const Eigen::Matrix<double, 3, 2> wanted = triangle.area * wanted_map(t);
    for (int corner = 0; corner < 3; ++corner)
      pull.col(triangle.corners(corner)) += wanted * triangle.gradients.row(corner).transpose();
  }
}

void StyleSystem::pull_soft(const std::vector<SoftTerm>& soft, Eigen::Matrix3Xd& pull) const {
  for (const SoftTerm& term : soft)
    pull.col(term.vertex) += term.weight * (term.goal - term.direction.dot(fixed_.col(term.vertex))) * term.direction;
}

Eigen::Matrix3Xd StyleSystem::solve_for(const Eigen::Matrix3Xd& pull, const BlockMatrix& matrix) const {
  Eigen::Matrix3Xd right(3, static_cast<Eigen::Index>(movers_.size()));
  for (std::size_t m = 0; m < movers_.size(); ++m)
    right.col(static_cast<Eigen::Index>(m)) = movers_[m].frame.transpose() * pull.col(movers_[m].vertex);
  const Eigen::Matrix3Xd y = matrix.solve(right);
  Eigen::Matrix3Xd x = fixed_;
  for (std::size_t m = 0; m < movers_.size(); ++m)
    x.col(movers_[m].vertex) += movers_[m].frame * y.col(static_cast<Eigen::Index>(m));
  return x;
}

Eigen::Matrix3Xd StyleSystem::solve(const std::vector<Eigen::Matrix2d>& maps) const {
  if (movers_.empty()) return fixed_;
  Eigen::Matrix3Xd pull = -fixed_pull_;
  pull_triangles([&](std::size_t t) -> Eigen::Matrix<double, 3, 2> { return triangles_[t].plane * maps[t]; }, pull);
  pull_soft(soft_, pull);
  return solve_for(pull, harmonic_->matrix());
}

Eigen::Matrix3Xd StyleSystem::solve_near(const Eigen::Matrix3Xd& guess) const {
  if (movers_.empty()) return fixed_;
  Eigen::Matrix3Xd pull = -fixed_pull_;
  pull_triangles([&](std::size_t t) { return map_of(triangles_[t], guess); }, pull);
  pull_soft(soft_, pull);
  return solve_for(pull, harmonic_->matrix());
}

Eigen::Matrix3Xd StyleSystem::solve_directly(const std::vector<SoftTerm>& soft, const std::vector<double>& stiffness,
                                             const std::vector<Eigen::Matrix2d>& maps, const Eigen::Matrix3Xd& force) const {
  if (movers_.empty()) return fixed_;
  const auto factor = memory_.factor(StyleMemory::Use::direct, static_cast<int>(movers_.size()), pairs_);
  Eigen::Matrix3Xd pull = Eigen::Matrix3Xd::Zero(3, fixed_.cols());
  const auto entry = [&](std::size_t t) -> Eigen::Matrix3d {
    const SourceTriangle& triangle = triangles_[t];
    const Eigen::Vector3d normal = triangle.plane.col(0).cross(triangle.plane.col(1));
    return triangle.area * (stiffness[t] * Eigen::Matrix3d::Identity() + (1 - stiffness[t]) * normal * normal.transpose());
  };
  assemble(entry, factor->fill(), pull);
  add_soft(soft, factor->fill());
  require(factor->factorise());
  pull = force - pull;
  pull_triangles([&](std::size_t t) -> Eigen::Matrix<double, 3, 2> { return stiffness[t] * triangles_[t].plane * maps[t]; },
                 pull);
  pull_soft(soft, pull);
  return solve_for(pull, factor->matrix());
}

}  // namespace toile
