#pragma once
// Points at random, the same on every run.

#include <Eigen/Core>
#include <random>

namespace toile::test {

class Points {
 public:
  explicit Points(unsigned seed) : engine_(seed) {}
  Eigen::Vector3d in_box(double half) { return half * Eigen::Vector3d(unit_(engine_), unit_(engine_), unit_(engine_)); }
  Eigen::Vector3d direction() {
    for (;;)
      if (const Eigen::Vector3d v = in_box(1); v.norm() < 1 && v.norm() > .1) return v.normalized();
  }
  double between(double low, double high) { return low + (high - low) * (unit_(engine_) + 1) / 2; }

 private:
  std::mt19937 engine_;
  std::uniform_real_distribution<double> unit_{-1, 1};
};

}  // namespace toile::test
