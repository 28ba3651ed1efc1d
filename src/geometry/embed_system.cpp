#include "geometry/embed_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace toile {
namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

double angle_of(const Eigen::Vector2d& v) { return std::atan2(v.y(), v.x()); }
double wrapped(double angle) { return std::remainder(angle, 2 * std::numbers::pi); }

// The first node of each connected component of a graph.
std::vector<int> component_roots(int nodes, const std::vector<std::array<int, 2>>& links) {
  std::vector<int> parent(static_cast<std::size_t>(nodes));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int node) {
    while (parent[static_cast<std::size_t>(node)] != node) {
      auto& up = parent[static_cast<std::size_t>(node)];
      up = parent[static_cast<std::size_t>(up)];
      node = up;
    }
    return node;
  };
  for (const auto& [a, b] : links) {
    const int ra = root(a), rb = root(b);
    parent[static_cast<std::size_t>(std::max(ra, rb))] = std::min(ra, rb);
  }
  std::vector<int> roots;
  for (int node = 0; node < nodes; ++node)
    if (root(node) == node) roots.push_back(node);
  return roots;
}

// Brings both vectors to the wanted ratio of lengths |u| / |v| with the least change.
void bring_to_ratio(double ratio, Eigen::Ref<Eigen::Vector2d> u, Eigen::Ref<Eigen::Vector2d> v) {
  const double lu = u.norm(), lv = v.norm();
  const double shared = (ratio * lu + lv) / (ratio * ratio + 1);
  if (lu > 0) u *= ratio * shared / lu;
  if (lv > 0) v *= shared / lv;
}

void add_link(Triplets& entries, int a, int b, double weight) {
  entries.emplace_back(a, a, weight);
  entries.emplace_back(b, b, weight);
  entries.emplace_back(a, b, -weight);
  entries.emplace_back(b, a, -weight);
}

}  // namespace

Eigen::Vector2d edge_of(const Eigen::Matrix2d& shape, int e) {
  if (e == 0) return shape.col(0);
  if (e == 1) return shape.col(1) - shape.col(0);
  return -shape.col(1);
}

double rotation_angle(const Eigen::Matrix2d& map) { return std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1)); }

Eigen::Matrix2d EmbedSystem::triangle_at(const Eigen::Matrix2Xd& at, Eigen::Index t) const {
  Eigen::Matrix2d edges;
  edges << at.col(triangles(1, t)) - at.col(triangles(0, t)), at.col(triangles(2, t)) - at.col(triangles(0, t));
  return edges;
}

void EmbedSystem::find_hinges(const std::vector<Eigen::Matrix2d>& reference) {
  struct Half {
    int low, high, triangle, edge;
  };
  std::vector<Half> sides;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int e = 0; e < 3; ++e) {
      const int a = triangles(e, t), b = triangles((e + 1) % 3, t);
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<int>(t), e});
    }
  std::sort(sides.begin(), sides.end(), [](const Half& x, const Half& y) {
    return std::array{x.low, x.high, x.triangle} < std::array{y.low, y.high, y.triangle};
  });
  for (std::size_t i = 1; i < sides.size(); ++i)
    if (sides[i].low == sides[i - 1].low && sides[i].high == sides[i - 1].high) {
      const Half &l = sides[i - 1], &r = sides[i];
      hinges.push_back(
          {l.triangle, r.triangle, l.edge, r.edge, edge_of(reference[static_cast<std::size_t>(l.triangle)], l.edge).norm()});
    }
}

void EmbedSystem::find_seams(const std::vector<MatingEdges>& mating) {
  std::map<std::array<int, 2>, std::array<int, 2>> half_edges;  // (from, to) -> (triangle, edge)
  for (Eigen::Index t = 0; t < triangles.cols() && !mating.empty(); ++t)
    for (int e = 0; e < 3; ++e) half_edges[{triangles(e, t), triangles((e + 1) % 3, t)}] = {static_cast<int>(t), e};
  const auto side = [&](int panel, int from, int to) -> Side {
    if (panel < 0 || panel >= static_cast<int>(panels.size()))
      throw std::invalid_argument("Embedder: mating edges name a panel that does not exist");
    const int shift = first_vertex[static_cast<std::size_t>(panel)];
    for (const double sign : {1.0, -1.0}) {
      const auto found =
          half_edges.find(sign > 0 ? std::array{from + shift, to + shift} : std::array{to + shift, from + shift});
      if (found != half_edges.end()) return {from + shift, to + shift, found->second[0], found->second[1], sign};
    }
    throw std::invalid_argument("Embedder: a mating edge is not an edge of its panel");
  };
  for (const MatingEdges& pair : mating) {
    if (!(pair.ratio > 0)) throw std::invalid_argument("Embedder: a mating ratio must be positive");
    seams.push_back({side(pair.panel_a, pair.a_from, pair.a_to), side(pair.panel_b, pair.b_from, pair.b_to), pair.ratio});
  }
}

void EmbedSystem::factor() {
  Triplets entries;
  std::vector<std::array<int, 2>> links;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int e = 0; e < 3; ++e) {
      add_link(entries, triangles(e, t), triangles((e + 1) % 3, t), cotangents(e, t));
      links.push_back({triangles(e, t), triangles((e + 1) % 3, t)});
    }
  for (const Seam& seam : seams) {
    add_link(entries, seam.a.from, seam.a.to, seam_weight);
    add_link(entries, seam.b.from, seam.b.to, seam_weight);
  }
  pinned = component_roots(vertex_count(), links);
  for (const int vertex : pinned) entries.emplace_back(vertex, vertex, 1.0);
  Sparse matrix(vertex_count(), vertex_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  laplacian.compute(matrix);

  entries.clear();
  links.clear();
  for (const Hinge& hinge : hinges) {
    add_link(entries, hinge.left, hinge.right, hinge.weight);
    links.push_back({hinge.left, hinge.right});
  }
  const int count = static_cast<int>(triangles.cols());
  for (const int triangle : component_roots(count, links)) entries.emplace_back(triangle, triangle, 1.0);
  Sparse dual(count, count);
  dual.setFromTriplets(entries.begin(), entries.end());
  dual_laplacian.compute(dual);
  if (laplacian.info() != Eigen::Success || dual_laplacian.info() != Eigen::Success)
    throw std::invalid_argument("Embedder: the reference triangles do not make a solvable system");
}

// Turns of the triangles that bring shared edges parallel, by least squares over the hinges. With them one global step is exact
// for triangles that agree, where local/global alone would creep along the bending modes of a long panel.
std::vector<double> EmbedSystem::first_angles(const std::vector<Eigen::Matrix2d>& shapes, const Eigen::Matrix2Xd& start) const {
  std::vector<double> angles(shapes.size());
  for (std::size_t t = 0; t < shapes.size(); ++t)
    angles[t] = rotation_angle(triangle_at(start, static_cast<Eigen::Index>(t)) * shapes[t].inverse());
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(triangles.cols());
  for (const Hinge& hinge : hinges) {
    const auto l = static_cast<std::size_t>(hinge.left), r = static_cast<std::size_t>(hinge.right);
    const double gap = wrapped(angles[l] + angle_of(edge_of(shapes[l], hinge.left_edge)) - angles[r] -
                               angle_of(-edge_of(shapes[r], hinge.right_edge)));
    wanted(hinge.right) += hinge.weight * gap;
    wanted(hinge.left) -= hinge.weight * gap;
  }
  const Eigen::VectorXd turns = dual_laplacian.solve(wanted);
  for (std::size_t t = 0; t < angles.size(); ++t) angles[t] += turns(static_cast<Eigen::Index>(t));
  return angles;
}

// What the turned triangles themselves ask of the seam edges.
Eigen::Matrix2Xd EmbedSystem::wanted_seams(const std::vector<Eigen::Matrix2d>& shapes,
                                           const std::vector<double>& angles) const {
  Eigen::Matrix2Xd pull(2, static_cast<Eigen::Index>(2 * seams.size()));
  const auto wanted = [&](const Side& side) -> Eigen::Vector2d {
    const auto t = static_cast<std::size_t>(side.triangle);
    return side.sign * (Eigen::Rotation2Dd(angles[t]) * edge_of(shapes[t], side.edge));
  };
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const auto column = static_cast<Eigen::Index>(2 * s);
    pull.col(column) = wanted(seams[s].a);
    pull.col(column + 1) = wanted(seams[s].b);
    bring_to_ratio(seams[s].ratio, pull.col(column), pull.col(column + 1));
  }
  return pull;
}

// Best rotations and seam vectors for the positions `at`; returns the energy.
double EmbedSystem::local_step(const std::vector<Eigen::Matrix2d>& shapes, const Eigen::Matrix2Xd& at,
                               std::vector<double>& angles, Eigen::Matrix2Xd& seam_pull) const {
  double energy = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto i = static_cast<std::size_t>(t);
    const Eigen::Matrix2d now = triangle_at(at, t);
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    double squares = 0;
    for (int e = 0; e < 3; ++e) {
      const Eigen::Vector2d u = edge_of(now, e), x = edge_of(shapes[i], e);
      covariance += cotangents(e, t) * u * x.transpose();
      squares += cotangents(e, t) * (u.squaredNorm() + x.squaredNorm());
    }
    angles[i] = rotation_angle(covariance);
    energy += squares - 2 * std::hypot(covariance(0, 0) + covariance(1, 1), covariance(1, 0) - covariance(0, 1));
  }
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const auto column = static_cast<Eigen::Index>(2 * s);
    const Eigen::Vector2d u = at.col(seams[s].a.to) - at.col(seams[s].a.from);
    const Eigen::Vector2d v = at.col(seams[s].b.to) - at.col(seams[s].b.from);
    seam_pull.col(column) = u;
    seam_pull.col(column + 1) = v;
    bring_to_ratio(seams[s].ratio, seam_pull.col(column), seam_pull.col(column + 1));
    energy += seam_weight * ((seam_pull.col(column) - u).squaredNorm() + (seam_pull.col(column + 1) - v).squaredNorm());
  }
  return energy;
}

Eigen::Matrix2Xd EmbedSystem::global_step(const std::vector<Eigen::Matrix2d>& shapes, const std::vector<double>& angles,
                                          const Eigen::Matrix2Xd& seam_pull, const Eigen::Matrix2Xd& start) const {
  Eigen::MatrixX2d pull = Eigen::MatrixX2d::Zero(vertex_count(), 2);
  const auto add = [&](int from, int to, const Eigen::Vector2d& vector) {
    pull.row(to) += vector.transpose();
    pull.row(from) -= vector.transpose();
  };
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto i = static_cast<std::size_t>(t);
    const Eigen::Matrix2d turned = Eigen::Rotation2Dd(angles[i]).toRotationMatrix() * shapes[i];
    for (int e = 0; e < 3; ++e) add(triangles(e, t), triangles((e + 1) % 3, t), cotangents(e, t) * edge_of(turned, e));
  }
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const auto column = static_cast<Eigen::Index>(2 * s);
    add(seams[s].a.from, seams[s].a.to, seam_weight * seam_pull.col(column));
    add(seams[s].b.from, seams[s].b.to, seam_weight * seam_pull.col(column + 1));
  }
  for (const int vertex : pinned) pull.row(vertex) += start.col(vertex).transpose();
  return Eigen::MatrixX2d(laplacian.solve(pull)).transpose();
}

}  // namespace toile
