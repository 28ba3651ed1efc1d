#pragma once
// What of a cloth is near to what: vertices to triangles and edges to edges.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "collide/listing.h"

namespace toile {

// What collides. Edges are those of the triangles; vertices of one group (the two sides of a stitch) count as one, so that what
// they belong to is joined and not near.
struct CollisionMesh {
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix2Xi edges;
  std::vector<int> corners;  // vertices that have triangles, ascending
  std::vector<int> group;    // by vertex
};

// Empty `group`: every vertex by itself.
CollisionMesh collision_mesh(const Eigen::Matrix3Xi& triangles, int vertex_count, std::vector<int> group = {});

// First side: vertex[0 .. first), second side: the rest. A vertex against a triangle has first = 1, an edge against an edge 2.
struct NearPair {
  std::array<int, 4> vertex{};
  int first = 1;
  Eigen::Vector4d weight = Eigen::Vector4d::Zero();  // of the closest points
  Eigen::Vector3d normal =
      Eigen::Vector3d::Zero();  // unit, from the second side's closest point to the first's; 0 if they touch
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  // between the closest points
  double distance = 0;                               // m
};

// Finds near pairs again and again while a cloth moves: what is within `distance` and twice a margin, at most `margin`, is
// listed once and looked through until something has moved by more than that. The same pairs as near_pairs gives.
class NearPairSearch {
 public:
  NearPairSearch(CollisionMesh mesh, double distance, double margin);
  std::vector<NearPair> find(const Eigen::Matrix3Xd& positions);
  double distance() const { return distance_; }

 private:
  CollisionMesh mesh_;
  double distance_;
  Listing listing_;
  std::vector<std::array<int, 2>> point_face_, edge_edge_;
};

// All pairs nearer than `distance` (m) that have no group in common, in the order of their vertices.
std::vector<NearPair> near_pairs(const Eigen::Matrix3Xd& positions, const CollisionMesh& mesh, double distance);

}  // namespace toile
