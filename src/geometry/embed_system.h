#pragma once
// The two halves of the embedding iteration, and what they need factored: private to embed.cpp.

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <vector>

#include "geometry/embed.h"

namespace toile {

// Edge e of a triangle shape [b - a, c - a] runs from corner e to corner e + 1.
Eigen::Vector2d edge_of(const Eigen::Matrix2d& shape, int e);
// Angle of the rotation nearest to `map`.
double rotation_angle(const Eigen::Matrix2d& map);

// All panels numbered through.
struct EmbedSystem {
  // A boundary edge from vertex to vertex: edge `edge` of `triangle`, or that turned round when `sign` is -1.
  struct Side {
    int from, to, triangle, edge;
    double sign;
  };
  struct Seam {
    Side a, b;
    double ratio;
  };
  // Triangles `left` and `right` share an edge, which is edge `left_edge` of one and, turned round, `right_edge` of the other.
  struct Hinge {
    int left, right, left_edge, right_edge;
    double weight;
  };

  std::vector<FlatMesh> panels;
  std::vector<int> first_vertex{0}, first_triangle{0};
  Eigen::Matrix3Xi triangles;
  Eigen::Matrix3Xd cotangents;  // of the corner facing edge e, i.e. corner e + 2
  Eigen::VectorXd areas;        // reference area by triangle
  std::vector<Seam> seams;
  std::vector<Hinge> hinges;
  std::vector<int> pinned;  // one vertex of each loose part
  double seam_weight = 0;
  EmbedOptions options;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> laplacian;       // vertices
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> dual_laplacian;  // triangles

  int vertex_count() const { return first_vertex.back(); }
  Eigen::Matrix2d triangle_at(const Eigen::Matrix2Xd& at, Eigen::Index t) const;
  void find_hinges(const std::vector<Eigen::Matrix2d>& reference);
  void find_seams(const std::vector<MatingEdges>& mating);
  void factor();
  std::vector<double> first_angles(const std::vector<Eigen::Matrix2d>& shapes, const Eigen::Matrix2Xd& start) const;
  Eigen::Matrix2Xd wanted_seams(const std::vector<Eigen::Matrix2d>& shapes, const std::vector<double>& angles) const;
  double local_step(const std::vector<Eigen::Matrix2d>& shapes, const Eigen::Matrix2Xd& at, std::vector<double>& angles,
                    Eigen::Matrix2Xd& seam_pull) const;
  Eigen::Matrix2Xd global_step(const std::vector<Eigen::Matrix2d>& shapes, const std::vector<double>& angles,
                               const Eigen::Matrix2Xd& seam_pull, const Eigen::Matrix2Xd& start) const;
  void align(Eigen::Matrix2Xd& at, const Eigen::Matrix2Xd& start) const;
};

}  // namespace toile
