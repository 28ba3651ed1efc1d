#pragma once
// Small cloths to collide.

#include <Eigen/Core>
#include <random>

namespace toile::test {

struct Sheet {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;
};

// n by n squares of side `cell` in the plane z = height, each of two triangles.
inline Sheet sheet(int n, double cell, double height) {
  Sheet made{Eigen::Matrix3Xd(3, (n + 1) * (n + 1)), Eigen::Matrix3Xi(3, 2 * n * n)};
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) made.positions.col(j * (n + 1) + i) << i * cell, j * cell, height;
  for (int j = 0, t = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      made.triangles.col(t++) << a, a + 1, a + n + 2;
      made.triangles.col(t++) << a, a + n + 2, a + n + 1;
    }
  return made;
}

inline Sheet both(const Sheet& a, const Sheet& b) {
  Sheet made{Eigen::Matrix3Xd(3, a.positions.cols() + b.positions.cols()),
             Eigen::Matrix3Xi(3, a.triangles.cols() + b.triangles.cols())};
  made.positions << a.positions, b.positions;
  made.triangles << a.triangles, b.triangles.array() + static_cast<int>(a.positions.cols());
  return made;
}

// Triangles of their own corners, at random in the unit cube.
inline Sheet scattered(int count, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> in(0, 1);
  Sheet made{Eigen::Matrix3Xd(3, 3 * count), Eigen::Matrix3Xi(3, count)};
  for (int t = 0; t < count; ++t) {
    Eigen::Vector3d middle;
    for (int k = 0; k < 3; ++k) middle(k) = in(random);
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) made.positions(k, 3 * t + i) = middle(k) + size * (in(random)-.5);
      made.triangles(i, t) = 3 * t + i;
    }
  }
  return made;
}

}  // namespace toile::test
