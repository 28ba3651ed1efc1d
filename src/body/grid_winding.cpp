#include "body/grid_winding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile {
namespace {

struct Flat {
  std::int64_t y, z;
};

// +1 when p is to the left of a -> b in the (y, z) plane, -1 to the right; 0 only when a == b.
int side(const Flat& p, const Flat& a, const Flat& b) {
  const std::int64_t dy = b.y - a.y, dz = b.z - a.z;
  const std::int64_t det = dy * (p.z - a.z) - dz * (p.y - a.y);
  if (det != 0) return det > 0 ? 1 : -1;
  if (dz != 0) return dz > 0 ? -1 : 1;
  return dy > 0 ? 1 : (dy < 0 ? -1 : 0);
}

}  // namespace

std::vector<std::int16_t> winding_on_grid(const GridFrame& grid, const Eigen::Matrix3Xd& positions,
                                          const Eigen::Matrix3Xi& triangles) {
  const double extent = grid.cell * static_cast<double>(grid.size.maxCoeff());
  const double scale = static_cast<double>(std::int64_t{1} << 29) / extent;
  const auto flat = [&](double y, double z) {
    return Flat{std::llround((y - grid.origin[1]) * scale), std::llround((z - grid.origin[2]) * scale)};
  };
  std::vector<Flat> rows_y(static_cast<std::size_t>(grid.size[1])), rows_z(static_cast<std::size_t>(grid.size[2]));
  for (int j = 0; j < grid.size[1]; ++j) rows_y[static_cast<std::size_t>(j)] = flat(grid.at(0, j, 0)[1], 0);
  for (int k = 0; k < grid.size[2]; ++k) rows_z[static_cast<std::size_t>(k)] = flat(0, grid.at(0, 0, k)[2]);

  std::vector<std::int16_t> winding(grid.nodes(), 0);
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    std::array<Eigen::Vector3d, 3> corner;
    std::array<Flat, 3> at;
    for (std::size_t c = 0; c < 3; ++c) {
      corner[c] = positions.col(triangles(static_cast<Eigen::Index>(c), t));
      at[c] = flat(corner[c][1], corner[c][2]);
    }
    const auto range = [&](int axis) {
      const auto [low, high] = std::minmax({corner[0][axis], corner[1][axis], corner[2][axis]});
      return std::pair{std::max(0, static_cast<int>((low - grid.origin[axis]) / grid.cell) - 1),
                       std::min(grid.size[axis] - 1, static_cast<int>((high - grid.origin[axis]) / grid.cell) + 1)};
    };
    const auto [j_first, j_last] = range(1);
    const auto [k_first, k_last] = range(2);
    for (int k = k_first; k <= k_last; ++k)
      for (int j = j_first; j <= j_last; ++j) {
        const Flat node{rows_y[static_cast<std::size_t>(j)].y, rows_z[static_cast<std::size_t>(k)].z};
        const int turn = side(node, at[0], at[1]);
        if (turn == 0 || side(node, at[1], at[2]) != turn || side(node, at[2], at[0]) != turn) continue;
        const auto area = [&](const Flat& a, const Flat& b) {
          return static_cast<double>((a.y - node.y) * (b.z - node.z) - (a.z - node.z) * (b.y - node.y));
        };
        const double a = area(at[1], at[2]), b = area(at[2], at[0]), c = area(at[0], at[1]), sum = a + b + c;
        const double x = sum != 0 ? (a * corner[0][0] + b * corner[1][0] + c * corner[2][0]) / sum : corner[0][0];
        const int from = std::clamp(static_cast<int>(std::ceil((x - grid.origin[0]) / grid.cell)), 0, grid.size[0] - 1);
        // The ray runs along +x: a triangle turned clockwise in (y, z) faces -x, so it is entered there.
        winding[grid.index(from, j, k)] = static_cast<std::int16_t>(winding[grid.index(from, j, k)] - turn);
      }
  }
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j) {
      std::int16_t* line = &winding[grid.index(0, j, k)];
      for (int i = 1; i < grid.size[0]; ++i) line[i] = static_cast<std::int16_t>(line[i] + line[i - 1]);
    }
  return winding;
}

}  // namespace toile
