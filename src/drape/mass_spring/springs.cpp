#include "drape/mass_spring/springs.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "geometry/topology.h"

namespace toile::mass_spring {
namespace {

constexpr double steepest = 12;  // times as stiff, at most, beyond the limit
constexpr double crumple_strain = 0.02;
constexpr double crumple_width = 0.02;
constexpr double crumpled_share = 0.15;
constexpr int fitting_rounds = 1;     // more make neighbours uneven and the drape no better
constexpr double least_share = 0.05;  // of the mean, that every spring keeps

using Harmonics = Eigen::Matrix<double, 5, 1>;

// 1, cos 2t, sin 2t, cos 4t, sin 4t of the angle between `edge` and the warp: what a fourth-order plane tensor is made of.
Harmonics harmonics(double angle) {
  Harmonics h;
  h << 1, std::cos(2 * angle), std::sin(2 * angle), std::cos(4 * angle), std::sin(4 * angle);
  return h;
}

// Sum of w * harmonics over springs of unit area whose tensor sum of w d x d x d x d is the given one.
Harmonics moments(const NetworkStiffness& c) {
  Harmonics m;
  m << c.warp + c.weft + 2 * c.cross, c.warp - c.weft, 0, c.warp + c.weft - 6 * c.cross, 0;
  return m;
}

// w as a combination of the harmonics where edges run evenly in all directions, three to a triangle.
Harmonics even_weights(const NetworkStiffness& c) {
  Harmonics w = 2.0 / 3 * moments(c);
  w(0) /= 2;
  return w;
}

NetworkStiffness with_cross(double young_warp, double young_weft, double cross) {
  const double share = (1 + std::sqrt(1 + 4 * cross * cross / (young_warp * young_weft))) / 2;
  return {young_warp * share, young_weft * share, cross};
}

double least_even_weight(const NetworkStiffness& c) {
  const Harmonics w = even_weights(c);
  double least = w(0);
  for (int i = 0; i <= 90; ++i) least = std::min(least, w.dot(harmonics(i * std::numbers::pi / 180)));
  return least;
}

struct RestTriangle {
  std::array<double, 3> angle{};   // of the edge from corner i to the next, against the warp
  std::array<double, 3> length{};  // m
  double area = 0;
};

std::vector<RestTriangle> rest_edges(const GarmentMesh& garment) {
  std::vector<RestTriangle> triangles;
  for (const PanelMesh& panel : garment.panels)
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      RestTriangle triangle;
      std::array<Eigen::Vector2d, 3> side;
      for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        side[k] = panel.rest.col(panel.triangles((i + 1) % 3, t)) - panel.rest.col(panel.triangles(i, t));
        const Eigen::Vector2d& w = panel.warp;
        triangle.angle[k] = std::atan2(w.x() * side[k].y() - w.y() * side[k].x(), w.dot(side[k]));
        triangle.length[k] = side[k].norm();
      }
      triangle.area = std::abs(side[0].x() * side[1].y() - side[0].y() * side[1].x()) / 2;
      triangles.push_back(triangle);
    }
  return triangles;
}

double strain(const Spring& spring, const Eigen::Vector3d& along) {
  return (along.squaredNorm() / (spring.rest * spring.rest) - 1) / 2;
}

using Weights = std::vector<std::array<double, 3>>;  // by triangle and its edge, N/m

// Weights with which the springs of the triangles around every vertex have the wanted tensor; where they run in too few
// directions to have it, the nearest to those of an even sheet. Found by correcting the share of each vertex.
Weights fitted_weights(const GarmentMesh& garment, const std::vector<RestTriangle>& triangles, const NetworkStiffness& wanted) {
  const Harmonics even = even_weights(wanted), goal = moments(wanted);
  const double least = least_share * even(0);
  const auto vertices = static_cast<std::size_t>(garment.vertex_count);
  const auto corner = [&](std::size_t t, std::size_t i) {
    return static_cast<std::size_t>(garment.triangles(static_cast<Eigen::Index>(i % 3), static_cast<Eigen::Index>(t)));
  };
  std::vector<Eigen::Matrix<double, 5, 5>> response(vertices, Eigen::Matrix<double, 5, 5>::Zero());
  std::vector<double> areas(vertices, 0.0);
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      areas[corner(t, i)] += triangles[t].area;
      for (const double angle : triangles[t].angle)
        response[corner(t, i)] += triangles[t].area * harmonics(angle) * harmonics(angle).transpose();
    }
  for (std::size_t v = 0; v < vertices; ++v) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 5, 5>> modes(response[v] / std::max(areas[v], 1e-12));
    response[v].setZero();  // from here on its inverse, in the directions there are
    for (int i = 0; i < 5; ++i)
      if (modes.eigenvalues()(i) > 0.05 * modes.eigenvalues()(4))
        response[v] += modes.eigenvectors().col(i) * modes.eigenvectors().col(i).transpose() / modes.eigenvalues()(i);
  }
  std::vector<Harmonics> share(vertices, even);
  Weights weights(triangles.size());
  for (int round = 0; round <= fitting_rounds; ++round) {
    std::vector<Harmonics> sums(vertices, Harmonics::Zero());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      Harmonics sum = Harmonics::Zero();
      for (std::size_t k = 0; k < 3; ++k) {
        const Harmonics h = harmonics(triangles[t].angle[k]);
        weights[t][k] = std::max(least, (share[corner(t, k)] + share[corner(t, k + 1)]).dot(h) / 2);
        sum += weights[t][k] * h;
      }
      for (std::size_t i = 0; i < 3; ++i) sums[corner(t, i)] += triangles[t].area * sum;
    }
    for (std::size_t v = 0; v < vertices; ++v)
      if (areas[v] > 0) share[v] += response[v] * (goal - sums[v] / areas[v]);
  }
  return weights;
}

}  // namespace

Pull pull_at(const SpringLaw& law, double strain) {
  Pull p{strain * strain / 2, strain, 1};
  const double excess = strain - law.limit;
  if (excess > 0) {
    const double k = 10 / law.limit;
    const double u = std::min(excess, (steepest - 1) / k), beyond = excess - u;
    p.energy += k * u * (u * u / 6 + beyond * (u + beyond) / 2);
    p.pull += k * u * (u / 2 + beyond);
    p.slope += k * u;
  }
  const double squeezed = -strain - crumple_strain;
  if (squeezed > 0) {
    constexpr double lost = 1 - crumpled_share;
    const double u = std::min(squeezed, crumple_width), beyond = squeezed - u;
    p.energy -= lost * (u * u * u / (6 * crumple_width) + beyond * (crumple_width / 2 + beyond / 2));
    p.pull += lost * (u * u / (2 * crumple_width) + beyond);
    p.slope -= lost * u / crumple_width;
  }
  return p;
}

double spring_energy(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x) {
  const Eigen::Vector3d along = x.col(spring.b) - x.col(spring.a);
  return spring.stiffness * spring.rest * spring.rest * pull_at(law, strain(spring, along)).energy;
}

Eigen::Vector3d spring_force(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x) {
  const Eigen::Vector3d along = x.col(spring.b) - x.col(spring.a);
  return spring.stiffness * pull_at(law, strain(spring, along)).pull * along;
}

Eigen::Matrix3d spring_stiffness(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x, double pull) {
  const Eigen::Vector3d along = x.col(spring.b) - x.col(spring.a);
  const double slope = pull_at(law, strain(spring, along)).slope;
  return spring.stiffness *
         (slope / (spring.rest * spring.rest) * along * along.transpose() + pull * Eigen::Matrix3d::Identity());
}

double pull_of(const SpringLaw& law, const Spring& spring, const Eigen::Matrix3Xd& x) {
  return pull_at(law, strain(spring, x.col(spring.b) - x.col(spring.a))).pull;
}

NetworkStiffness network_stiffness(const Fabric& fabric) {
  const double young_warp = fabric.stretch_warp - fabric.stretch_cross * fabric.stretch_cross / fabric.stretch_weft;
  const double young_weft = fabric.stretch_weft - fabric.stretch_cross * fabric.stretch_cross / fabric.stretch_warp;
  double cross = (fabric.stretch_cross + 2 * fabric.shear) / 3;
  NetworkStiffness c = with_cross(young_warp, young_weft, cross);
  while (least_even_weight(c) < least_share * even_weights(c)(0)) {
    cross = 1.02 * cross + 1e-3 * std::min(young_warp, young_weft);
    c = with_cross(young_warp, young_weft, cross);
  }
  return c;
}

std::vector<Spring> edge_springs(const GarmentMesh& garment, const Fabric& fabric) {
  const std::vector<RestTriangle> triangles = rest_edges(garment);
  const NetworkStiffness wanted = network_stiffness(fabric);
  const Weights weights = fitted_weights(garment, triangles, wanted);
  const Eigen::VectorXd layers = triangle_layers(garment);
  std::vector<Spring> springs;
  for (const MeshEdge& edge : mesh_edges(garment.triangles)) {
    std::array<Spring, 2> sides;
    for (std::size_t s = 0; s < 2; ++s) {
      if (!is_new(edge, s)) continue;
      const int t = edge.triangle[s];
      std::size_t k = 0;
      while (garment.triangles(static_cast<Eigen::Index>(k), t) == edge.opposite[s] ||
             garment.triangles(static_cast<Eigen::Index>((k + 1) % 3), t) == edge.opposite[s])
        ++k;
      const RestTriangle& triangle = triangles[static_cast<std::size_t>(t)];
      const double w = weights[static_cast<std::size_t>(t)][k];
      const double length = triangle.length[k];
      sides[s] = {edge.vertex[0], edge.vertex[1], length, w * layers(t) * triangle.area / (length * length)};
    }
    if (edge.triangle[1] >= 0 && std::abs(sides[0].rest - sides[1].rest) < 1e-9) {
      sides[0].stiffness += sides[1].stiffness;
      springs.push_back(sides[0]);
    } else {
      for (const Spring& side : sides)
        if (side.stiffness > 0) springs.push_back(side);
    }
  }
  return springs;
}

}  // namespace toile::mass_spring
