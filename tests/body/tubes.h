#pragma once
// Round test surfaces: closed cylinders for limbs, open tubes for garments.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "body/shapes.h"

namespace toile::test {

// Closed round cylinder from a to b; `across` vertices round, `along` rings of side faces.
inline Closed cylinder(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double radius, int across = 48, int along = 24) {
  const Eigen::Vector3d axis = (b - a).normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
  std::vector<Eigen::Vector3d> points;
  for (int ring = 0; ring <= along; ++ring)
    for (int i = 0; i < across; ++i) {
      const double angle = 2 * std::numbers::pi * i / across;
      points.push_back(a + (b - a) * ring / along + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
  points.push_back(a);
  points.push_back(b);
  std::vector<Eigen::Vector3i> faces;
  const int first = static_cast<int>(points.size()) - 2, last = first + 1, top = along * across;
  for (int i = 0; i < across; ++i) {
    const int next = (i + 1) % across;
    for (int ring = 0; ring < along; ++ring) {
      const int here = ring * across, there = here + across;
      faces.emplace_back(here + i, here + next, there + next);
      faces.emplace_back(here + i, there + next, there + i);
    }
    faces.emplace_back(first, next, i);
    faces.emplace_back(last, top + i, top + next);
  }
  return closed(points, faces);
}

// Open tube of triangles round the y axis through `centre`: what a skirt or a sleeve is to these tests. Radius at the top and
// at the bottom.
inline Closed tube(const Eigen::Vector3d& top, const Eigen::Vector3d& bottom, double radius_top, double radius_bottom,
                   int across = 40, int along = 30) {
  Closed shape = cylinder(bottom, top, 1, across, along);
  const Eigen::Index sides = 2 * across * along;
  Closed open{shape.positions.leftCols((along + 1) * across), Eigen::Matrix3Xi(3, sides)};
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < shape.triangles.cols(); ++t)
    if (shape.triangles.col(t).maxCoeff() < open.positions.cols()) open.triangles.col(kept++) = shape.triangles.col(t);
  for (Eigen::Index v = 0; v < open.positions.cols(); ++v) {
    const double t = static_cast<double>(v / across) / along;
    const Eigen::Vector3d middle = (1 - t) * bottom + t * top;
    open.positions.col(v) = middle + ((1 - t) * radius_bottom + t * radius_top) * (open.positions.col(v) - middle);
  }
  return open;
}

}  // namespace toile::test
