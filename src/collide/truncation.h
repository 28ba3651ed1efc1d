#pragma once
// Keeps a cloth without intersections free of them, whatever moves it: every near pair gets a plane between its two sides that
// neither may cross ("Divide and truncate", planes at the middle of the closest points).

#include <Eigen/Core>
#include <vector>

#include "collide/near_pairs.h"

namespace toile {

class Truncation {
 public:
  // `positions` have no intersections; pairs up to `reach` (m) are parted by planes, everything else by not moving farther than
  // .45 of it.
  Truncation(Eigen::Matrix3Xd positions, const CollisionMesh& mesh, double reach);
  Truncation(Eigen::Matrix3Xd positions, NearPairSearch& search);

  // Moves `from` towards `to` as far as is allowed, along the planes where they are in the way. `from` is what the constructor
  // or this function gave. How far the vertex that fell most behind is from `to`, m; 0 when all got there.
  double advance(Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) const;

  const std::vector<NearPair>& pairs() const { return pairs_; }

 private:
  void make_planes();
  struct Plane {  // normal . x >= offset
    Eigen::Vector3d normal;
    double offset;
  };
  Eigen::Vector3d allowed(Eigen::Index v, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

  Eigen::Matrix3Xd start_;
  double longest_;
  std::vector<NearPair> pairs_;
  std::vector<Plane> planes_;  // by vertex
  std::vector<int> begin_;     // first plane of each vertex, and the number of planes
};

}  // namespace toile
