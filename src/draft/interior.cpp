#include "draft/interior.h"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace toile {
namespace {

double twice_area(const Eigen::Matrix2Xd& at, const Eigen::Matrix3Xi& triangles, Eigen::Index t) {
  const Eigen::Vector2d u = at.col(triangles(1, t)) - at.col(triangles(0, t)),
                        v = at.col(triangles(2, t)) - at.col(triangles(0, t));
  return u.x() * v.y() - u.y() * v.x();
}

int inverted_count(const Eigen::Matrix2Xd& at, const Eigen::Matrix3Xi& triangles) {
  int count = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) count += !(twice_area(at, triangles, t) > 0);
  return count;
}

// Cotangent of the corner facing edge e (from corner e to corner e + 1).
Eigen::Matrix3Xd cotangents_of(const Eigen::Matrix2Xd& at, const Eigen::Matrix3Xi& triangles) {
  Eigen::Matrix3Xd cotangents(3, triangles.cols());
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int e = 0; e < 3; ++e) {
      const Eigen::Vector2d top = at.col(triangles((e + 2) % 3, t));
      const Eigen::Vector2d u = at.col(triangles(e, t)) - top, v = at.col(triangles((e + 1) % 3, t)) - top;
      cotangents(e, t) = u.dot(v) / twice_area(at, triangles, t);
    }
  return cotangents;
}

// `like` moved and turned as a whole to lie best on the boundary.
Eigen::Matrix2Xd moved_onto(const Eigen::Matrix2Xd& like, const std::vector<int>& boundary, const Eigen::Matrix2Xd& targets) {
  Eigen::Matrix2Xd from(2, targets.cols());
  for (std::size_t i = 0; i < boundary.size(); ++i) from.col(static_cast<Eigen::Index>(i)) = like.col(boundary[i]);
  const Eigen::Vector2d a = from.rowwise().mean(), b = targets.rowwise().mean();
  const Eigen::Matrix2d covariance = (targets.colwise() - b) * (from.colwise() - a).transpose();
  const double angle = std::atan2(covariance(1, 0) - covariance(0, 1), covariance(0, 0) + covariance(1, 1));
  return (Eigen::Rotation2Dd(angle).toRotationMatrix() * (like.colwise() - a)).colwise() + b;
}

// Moves the inner vertices of inverted and almost flat triangles to where the smallest triangle round them is largest.
void untangle(Eigen::Matrix2Xd& at, const Eigen::Matrix3Xi& triangles, const std::vector<bool>& fixed) {
  std::vector<std::vector<Eigen::Index>> around(static_cast<std::size_t>(at.cols()));
  double mean = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (int corner = 0; corner < 3; ++corner) around[static_cast<std::size_t>(triangles(corner, t))].push_back(t);
    mean += std::abs(twice_area(at, triangles, t)) / static_cast<double>(triangles.cols());
  }
  const auto smallest = [&](std::size_t v) {
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Index t : around[v]) least = std::min(least, twice_area(at, triangles, t));
    return least;
  };
  for (int sweep = 0; sweep < 60 && inverted_count(at, triangles) > 0; ++sweep)
    for (std::size_t v = 0; v < around.size(); ++v) {
      if (fixed[v] || around[v].empty() || smallest(v) > .05 * mean) continue;
      const auto column = static_cast<Eigen::Index>(v);
      double best = smallest(v);
      for (double reach = std::sqrt(mean); reach > 1e-3 * std::sqrt(mean); reach /= 2)
        for (int direction = 0; direction < 8; ++direction) {
          const Eigen::Vector2d before = at.col(column);
          const double angle = direction * std::numbers::pi / 4;
          at.col(column) += reach * Eigen::Vector2d(std::cos(angle), std::sin(angle));
          const double now = smallest(v);
          if (now > best)
            best = now;
          else
            at.col(column) = before;
        }
    }
}

}  // namespace

LaidPanel lay_panel(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& like, const Eigen::Matrix2Xd& fallback,
                    const std::vector<int>& boundary, const Eigen::Matrix2Xd& targets) {
  const Eigen::Matrix2Xd& reference = inverted_count(like, triangles) == 0 ? like : fallback;
  const Eigen::Index count = reference.cols();
  std::vector<bool> fixed(static_cast<std::size_t>(count), false);
  Eigen::Matrix2Xd at = moved_onto(reference, boundary, targets);
  const Eigen::Matrix2Xd shape = at;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    fixed[static_cast<std::size_t>(boundary[i])] = true;
    at.col(boundary[i]) = targets.col(static_cast<Eigen::Index>(i));
  }
  std::vector<int> number(static_cast<std::size_t>(count), -1);
  int inner = 0;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (!fixed[v]) number[v] = inner++;
  if (inner == 0) return {at, inverted_count(at, triangles)};

  const Eigen::Matrix3Xd cotangents = cotangents_of(shape, triangles);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add_system = [&](int i, int j, double w) {
    const int a = number[static_cast<std::size_t>(i)], b = number[static_cast<std::size_t>(j)];
    if (a < 0) return;
    entries.emplace_back(a, a, w);
    if (b >= 0) entries.emplace_back(a, b, -w);
  };
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int e = 0; e < 3; ++e) {
      add_system(triangles(e, t), triangles((e + 1) % 3, t), cotangents(e, t));
      add_system(triangles((e + 1) % 3, t), triangles(e, t), cotangents(e, t));
    }
  Eigen::SparseMatrix<double> matrix(inner, inner);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  if (factor.info() != Eigen::Success) throw std::invalid_argument("rest_on_outlines: a vertex belongs to no triangle");

  // Round 0 spreads the boundary's movement evenly (no turns); the following ones turn every triangle as it lies.
  for (int round = 0; round < 30; ++round) {
    Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(inner, 2);
    for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
      Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();
      if (round > 0) {
        Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
        for (int e = 0; e < 3; ++e) {
          const int i = triangles(e, t), j = triangles((e + 1) % 3, t);
          covariance += cotangents(e, t) * (at.col(j) - at.col(i)) * (shape.col(j) - shape.col(i)).transpose();
        }
        turn = Eigen::Rotation2Dd(std::atan2(covariance(1, 0) - covariance(0, 1), covariance(0, 0) + covariance(1, 1)))
                   .toRotationMatrix();
      }
      for (int e = 0; e < 3; ++e) {
        const int i = triangles(e, t), j = triangles((e + 1) % 3, t);
        const double w = cotangents(e, t);
        const Eigen::Vector2d pull = w * (turn * (shape.col(j) - shape.col(i)));
        const int a = number[static_cast<std::size_t>(i)], b = number[static_cast<std::size_t>(j)];
        if (a >= 0) right.row(a) += (b < 0 ? Eigen::Vector2d(w * at.col(j) - pull) : Eigen::Vector2d(-pull)).transpose();
        if (b >= 0) right.row(b) += (a < 0 ? Eigen::Vector2d(w * at.col(i) + pull) : pull).transpose();
      }
    }
    const Eigen::MatrixX2d solved = factor.solve(right);
    double move = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
      if (number[v] < 0) continue;
      const Eigen::Vector2d now = solved.row(number[v]).transpose();
      move = std::max(move, (now - at.col(static_cast<Eigen::Index>(v))).norm());
      at.col(static_cast<Eigen::Index>(v)) = now;
    }
    if (round > 0 && move < 1e-7) break;
  }
  if (inverted_count(at, triangles) > 0) untangle(at, triangles, fixed);
  return {at, inverted_count(at, triangles)};
}

}  // namespace toile
