#pragma once
// Closed test surfaces with a closed form.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace toile::test {

struct Closed {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
};

inline Closed closed(const std::vector<Eigen::Vector3d>& points, const std::vector<Eigen::Vector3i>& faces) {
  Closed shape{Eigen::Matrix3Xd(3, points.size()), Eigen::Matrix3Xi(3, faces.size())};
  for (std::size_t i = 0; i < points.size(); ++i) shape.positions.col(static_cast<Eigen::Index>(i)) = points[i];
  for (std::size_t i = 0; i < faces.size(); ++i) shape.triangles.col(static_cast<Eigen::Index>(i)) = faces[i];
  return shape;
}

// Axis-parallel box of half sizes `half` round `centre`: 8 vertices, 12 triangles.
inline Closed box(const Eigen::Vector3d& centre, const Eigen::Vector3d& half) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i)
    points.push_back(centre + half.cwiseProduct(Eigen::Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  return closed(points, {{0, 2, 1},
                         {1, 2, 3},
                         {4, 5, 6},
                         {5, 7, 6},
                         {0, 1, 4},
                         {1, 5, 4},
                         {2, 6, 3},
                         {3, 6, 7},
                         {0, 4, 2},
                         {2, 4, 6},
                         {1, 3, 5},
                         {3, 7, 5}});
}

// Octahedron refined `times` times: 8 * 4^times triangles, vertices on the sphere.
inline Closed sphere(const Eigen::Vector3d& centre, double radius, int times) {
  std::vector<Eigen::Vector3d> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Eigen::Vector3i> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int round = 0; round < times; ++round) {
    std::map<std::pair<int, int>, int> middle;
    const auto between = [&](int a, int b) {
      const auto [entry, fresh] = middle.try_emplace(std::minmax(a, b), static_cast<int>(points.size()));
      if (fresh) points.push_back((points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)]).normalized());
      return entry->second;
    };
    std::vector<Eigen::Vector3i> finer;
    for (const Eigen::Vector3i& f : faces) {
      const int ab = between(f[0], f[1]), bc = between(f[1], f[2]), ca = between(f[2], f[0]);
      for (const Eigen::Vector3i& part : {Eigen::Vector3i(f[0], ab, ca), Eigen::Vector3i(ab, f[1], bc),
                                          Eigen::Vector3i(ca, bc, f[2]), Eigen::Vector3i(ab, bc, ca)})
        finer.push_back(part);
    }
    faces = std::move(finer);
  }
  for (Eigen::Vector3d& p : points) p = centre + radius * p;
  return closed(points, faces);
}

// Both surfaces as one mesh.
inline Closed both(const Closed& a, const Closed& b) {
  Closed sum{Eigen::Matrix3Xd(3, a.positions.cols() + b.positions.cols()),
             Eigen::Matrix3Xi(3, a.triangles.cols() + b.triangles.cols())};
  sum.positions << a.positions, b.positions;
  sum.triangles << a.triangles, (b.triangles.array() + static_cast<int>(a.positions.cols())).matrix();
  return sum;
}

inline Closed turned_over(Closed shape) {
  shape.triangles.row(1).swap(shape.triangles.row(2));
  return shape;
}

inline Closed without_triangle(const Closed& shape, Eigen::Index triangle) {
  Closed open = shape;
  open.triangles.resize(3, shape.triangles.cols() - 1);
  open.triangles << shape.triangles.leftCols(triangle), shape.triangles.rightCols(shape.triangles.cols() - triangle - 1);
  return open;
}

}  // namespace toile::test
