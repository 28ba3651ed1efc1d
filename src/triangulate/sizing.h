#pragma once
// How large triangles are to be inside a polygon, and how far a place inside is from its sides.

#include <Eigen/Core>
#include <vector>

namespace toile {

class Sizing {
 public:
  Sizing(std::vector<Eigen::Vector2d> loop, double edge_length);

  // m: `edge_length`, less near sides that are shorter, growing away from them.
  double size(const Eigen::Vector2d& place) const;

  // Whether `place` lies inside the polygon, at least `margin` (m) from each side.
  bool inside(const Eigen::Vector2d& place, double margin) const;

 private:
  struct Fine {
    Eigen::Vector2d at;
    double spacing;
  };
  std::vector<Eigen::Vector2d> loop_;
  std::vector<Fine> fine_;  // corners with short sides
  double edge_length_;
};

}  // namespace toile
