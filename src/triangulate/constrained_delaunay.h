#pragma once
// Constrained Delaunay triangulation of a simple polygon with points inside it (CGAL behind it).

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

namespace toile {

struct DelaunayTriangle {
  std::array<int, 3> vertex;  // counter-clockwise
  std::array<int, 3>
      neighbour;  // place in the list of the triangle across the side opposite to each vertex, -1 outside the polygon
};

// Vertices are numbered in the order they were given, the polygon's first. Its sides are kept as they are.
class ConstrainedDelaunay {
 public:
  // `loop`: simple, counter-clockwise. Throws std::invalid_argument when it crosses itself.
  explicit ConstrainedDelaunay(const std::vector<Eigen::Vector2d>& loop);
  ~ConstrainedDelaunay();
  ConstrainedDelaunay(const ConstrainedDelaunay&) = delete;
  ConstrainedDelaunay& operator=(const ConstrainedDelaunay&) = delete;

  // A point inside the polygon; the search for its place starts at vertex `near`.
  void insert(const Eigen::Vector2d& point, int near);

  // The triangles inside the polygon.
  std::vector<DelaunayTriangle> triangles();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toile
