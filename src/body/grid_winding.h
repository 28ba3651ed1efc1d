#pragma once
// Which nodes of a regular grid lie inside a closed surface.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace toile {

// Node (i, j, k) of a grid sits at origin + cell * (i, j, k); x runs fastest in storage.
struct GridFrame {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  double cell = 0;  // m
  Eigen::Vector3i size = Eigen::Vector3i::Zero();

  std::size_t nodes() const {
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2]);
  }
  std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
  Eigen::Vector3d at(int i, int j, int k) const { return origin + cell * Eigen::Vector3d(i, j, k); }
};

// How often the surface winds round each node: 1 inside, 0 outside, 2 where two parts overlap. `triangles` closed and oriented
// outwards, all within the grid. Exact: the surface's (y, z) are rounded to 2^-29 of its size, the rest is integer arithmetic
// with the node shifted by (eps, eps^2) when it falls on an edge (Edelsbrunner and Muecke 1990).
std::vector<std::int16_t> winding_on_grid(const GridFrame& grid, const Eigen::Matrix3Xd& positions,
                                          const Eigen::Matrix3Xi& triangles);

}  // namespace toile
