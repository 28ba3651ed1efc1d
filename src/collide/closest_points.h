#pragma once
// Closest points of the two kinds of pairs that cloth meets in.

#include <Eigen/Core>

namespace toile {

// Weights of the corners in the two closest points, and their distance (m).
struct ClosestPoints {
  Eigen::Vector4d weight = Eigen::Vector4d::Zero();  // first side, then second side; each side sums to 1
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();   // from the second side's point to the first side's
  double distance = 0;
};

// Point p (first side) and triangle a b c (Ericson, Real-Time Collision Detection 5.1.5). A degenerate triangle counts as its
// edges.
ClosestPoints closest_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c);

// Segments a b (first side) and c d; parallel ones give one of their nearest pairs (same book, 5.1.9).
ClosestPoints closest_of_segments(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                  const Eigen::Vector3d& d);

}  // namespace toile
