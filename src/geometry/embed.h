#pragma once
// Laying loose triangles flat again: the embedding step of the paper (Sec. 4), after Liu et al. 2008 (local/global, ARAP), for
// triangles that no longer agree on their shared edges, with mating seam edges kept at an intended length ratio.

#include <Eigen/Core>
#include <vector>

#include <memory>

namespace toile {

// A flat piece: triangles over its own vertices (counter-clockwise).
struct FlatMesh {
  Eigen::Index vertex_count = 0;
  Eigen::Matrix3Xi triangles;
};

// Two edges of (possibly) different panels that are sewn together: panel, from-vertex, to-vertex of both sides, and the ratio
// length(a) / length(b) to keep.
struct MatingEdges {
  int panel_a, a_from, a_to;
  int panel_b, b_from, b_to;
  double ratio = 1;
};

struct EmbedOptions {
  double seam_weight = 10;  // against the mean cotangent weight of a triangle edge
  int most_iterations = 60;
  double tolerance = 1e-7;  // m, largest move of a vertex in one iteration
};

struct Embedding {
  std::vector<Eigen::Matrix2Xd> panels;
  double mean_distortion = 0;      // area-weighted mean of |s1 - 1| + |s2 - 1| over 2
  std::vector<double> distortion;  // by triangle, panels in order
  int iterations = 0;
};

// Factors once, embeds often. Every result is aligned to `start` panel by panel (best rotation and shift), so grain stays put.
class Embedder {
 public:
  // `reference[i]`: rest shape columns [b - a, c - a] of the i-th triangle, used for the fixed cotangent weights.
  Embedder(std::vector<FlatMesh> panels, std::vector<MatingEdges> mating, const std::vector<Eigen::Matrix2d>& reference,
           EmbedOptions options = {});
  ~Embedder();
  Embedder(Embedder&&) noexcept;
  Embedder& operator=(Embedder&&) noexcept;

  // `shapes[i]`: wanted shape of triangle i, as [b - a, c - a] up to a rotation.
  Embedding embed(const std::vector<Eigen::Matrix2d>& shapes, const std::vector<Eigen::Matrix2Xd>& start) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toile
