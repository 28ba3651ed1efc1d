#pragma once
// Does cloth pass through itself? Decided exactly.

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "collide/listing.h"

namespace toile {

// Pairs of triangles (smaller index first, sorted) that intersect, by exact predicates. Triangles that share one vertex count
// when they meet anywhere else; two triangles that share an edge never count, nor does a triangle without area.
std::vector<std::pair<int, int>> intersecting_triangles(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

// Asks the same again and again while a cloth moves; lists once which triangles are near to which.
class IntersectionSearch {
 public:
  IntersectionSearch(Eigen::Matrix3Xi triangles, double margin);
  bool any(const Eigen::Matrix3Xd& positions);

 private:
  Eigen::Matrix3Xi triangles_;
  Listing listing_;
  std::vector<std::pair<int, int>> near_;
};

}  // namespace toile
