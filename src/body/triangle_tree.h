#pragma once
// Nearest point and ray questions about a triangle surface, by a tree of boxes.

#include <Eigen/Core>
#include <limits>
#include <memory>
#include <vector>

namespace toile {

struct NearestPoint {
  int triangle = -1;  // -1: nothing within the distance asked for
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double distance = 0;  // m, unsigned
};

// Immutable and cheap to copy; queries may run in several threads.
class TriangleTree {
  struct Nodes;

 public:
  TriangleTree() = default;
  TriangleTree(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles);

  // The point of the surface nearest to `query`, looked for up to `within` m. `guess`: a triangle that is probably near.
  NearestPoint nearest(const Eigen::Vector3d& query, double within = std::numeric_limits<double>::infinity(),
                       int guess = -1) const;

  // Distances from many points close together, cheaper than asking for each.
  class Neighbourhood {
   public:
    // Distance from `query`, which lies within `reach` of `centre`.
    double distance(const Eigen::Vector3d& query) const;

   private:
    friend class TriangleTree;
    struct Candidate {
      double from_centre;  // m, at least
      int place;
    };
    std::shared_ptr<const Nodes> nodes_;
    Eigen::Vector3d centre_;
    std::vector<Candidate> candidates_;  // nearest first
  };
  // `distance`: from `centre` to the surface.
  Neighbourhood around(const Eigen::Vector3d& centre, double distance, double reach) const;

  // Fractions t in [0, most] at which from + t * step crosses a triangle, sorted; a crossing on an edge may be given twice.
  std::vector<double> crossings(const Eigen::Vector3d& from, const Eigen::Vector3d& step, double most = 1) const;

  // Triangles that the segment from..to passes through, ascending.
  std::vector<int> pierced(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const;

 private:
  std::shared_ptr<const Nodes> nodes_;
};

}  // namespace toile
