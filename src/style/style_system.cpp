#include "style/style_system.h"

#include <stdexcept>

namespace toile {

StyleSystem::StyleSystem(const std::vector<SourceTriangle>& triangles, const HardConstraints& constraints,
                         Eigen::Index vertex_count)
    : fixed_(Eigen::Matrix3Xd::Zero(3, vertex_count)),
      freedom_(static_cast<std::size_t>(vertex_count)),
      first_(static_cast<std::size_t>(vertex_count), 0),
      triangles_(triangles),
      fixed_pull_(Eigen::Matrix3Xd::Zero(3, vertex_count)) {
  std::vector<bool> in_triangle(static_cast<std::size_t>(vertex_count), false);
  for (const SourceTriangle& triangle : triangles)
    for (int corner = 0; corner < 3; ++corner) in_triangle[static_cast<std::size_t>(triangle.corners(corner))] = true;
  for (const auto& [vertex, freedom] : constraints.vertices) {
    if (vertex < 0 || vertex >= vertex_count)
      throw std::invalid_argument("StyleSystem: constraint on a vertex that is not there");
    freedom_[static_cast<std::size_t>(vertex)] = freedom;
    fixed_.col(vertex) = freedom.fixed;
  }
  for (std::size_t v = 0; v < freedom_.size(); ++v) {
    if (!in_triangle[v] && freedom_[v].free.cols() > 0)
      throw std::invalid_argument("StyleSystem: vertex " + std::to_string(v) + " is in no triangle and not held");
    first_[v] = freedoms_;
    freedoms_ += freedom_[v].free.cols();
  }

  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const SourceTriangle& triangle = triangles_[t];
    bool moves = false;
    for (int i = 0; i < 3; ++i) {
      const auto vi = static_cast<std::size_t>(triangle.corners(i));
      moves = moves || freedom_[vi].free.cols() > 0;
      for (int j = 0; j < 3; ++j) {
        const auto vj = static_cast<std::size_t>(triangle.corners(j));
        const double entry = triangle.area * triangle.gradients.row(i).dot(triangle.gradients.row(j));
        fixed_pull_.col(triangle.corners(i)) += entry * fixed_.col(triangle.corners(j));
        if (first_[vi] < first_[vj]) continue;
        const auto block = (freedom_[vi].free.transpose() * freedom_[vj].free).eval();
        for (Eigen::Index r = 0; r < block.rows(); ++r)
          for (Eigen::Index c = 0; c < block.cols(); ++c)
            if (first_[vi] + r >= first_[vj] + c && (i == j || block(r, c) != 0))
              entries.emplace_back(first_[vi] + r, first_[vj] + c, entry * block(r, c));
      }
    }
    if (moves) moving_.push_back(t);
  }
  laplacian_.resize(freedoms_, freedoms_);
  laplacian_.setFromTriplets(entries.begin(), entries.end());
}

void StyleSystem::factor(std::vector<SoftTerm> soft) {
  soft_ = std::move(soft);
  if (freedoms_ == 0) return;
  Eigen::SparseMatrix<double> matrix = laplacian_;
  for (const SoftTerm& term : soft_) {
    const auto v = static_cast<std::size_t>(term.vertex);
    const Eigen::VectorXd along = freedom_[v].free.transpose() * term.direction;
    for (Eigen::Index r = 0; r < along.size(); ++r)
      for (Eigen::Index c = 0; c <= r; ++c) matrix.coeffRef(first_[v] + r, first_[v] + c) += term.weight * along(r) * along(c);
  }
  if (!analysed_) factor_.analyzePattern(matrix);
  analysed_ = true;
  factor_.factorize(matrix);
  const double least = factor_.info() == Eigen::Success ? factor_.vectorD().minCoeff() : 0;
  if (!(least > 1e-10 * factor_.vectorD().maxCoeff()))
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
  if (freedoms_ == 0) return x;
  Eigen::VectorXd right(freedoms_);
  for (std::size_t v = 0; v < freedom_.size(); ++v)
    right.segment(first_[v], freedom_[v].free.cols()) = freedom_[v].free.transpose() * pull.col(static_cast<Eigen::Index>(v));
  const Eigen::VectorXd y = factor_.solve(right);
  for (std::size_t v = 0; v < freedom_.size(); ++v)
    x.col(static_cast<Eigen::Index>(v)) += freedom_[v].free * y.segment(first_[v], freedom_[v].free.cols());
  return x;
}

Eigen::Matrix3Xd StyleSystem::solve(const std::vector<Eigen::Matrix2d>& maps) const {
  return solve_for([&](std::size_t t) -> Eigen::Matrix<double, 3, 2> { return triangles_[t].plane * maps[t]; });
}

Eigen::Matrix3Xd StyleSystem::solve_near(const Eigen::Matrix3Xd& guess) const {
  return solve_for([&](std::size_t t) { return map_of(triangles_[t], guess); });
}

}  // namespace toile
