#pragma once
// Laying loose triangles flat again: the embedding step of the paper (Sec. 4), after Liu et al. 2008 (local/global, ARAP), for
// triangles that no longer agree on their shared edges, with mating seam edges kept at an intended length ratio.

#include <Eigen/Core>
#include <memory>
#include <vector>

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
  // Against the mean cotangent weight of a triangle edge, at 500 triangles a panel; scaled with resolution. 50 leaves a tenth
  // of what the seams' own triangles disagree by.
  double seam_weight = 50;
  int most_iterations = 60;
  double tolerance = 1e-7;  // m, largest move of a vertex in one iteration
};

struct Embedding {
  std::vector<Eigen::Matrix2Xd> panels;
  double mean_distortion = 0;      // area-weighted mean of |s1 - 1| + |s2 - 1| over 2
  std::vector<double> distortion;  // by triangle, panels in order
  int inverted = 0;                // triangles that came out with the other orientation
  int iterations = 0;
};

// Factors once, embeds often. Guarantees:
//  1. Triangles that agree on their shared edges (and meet the mating ratios) come back exactly.
//  2. Every panel is turned so that its mean rotation against `start`, weighted by area, is zero, so grain stays put, and
//     shifted so that its centroid is where it was.
//  3. A mating pair is drawn towards its ratio, never towards equal lengths; the sum of both lengths stays free.
class Embedder {
 public:
  // `reference[i]`: rest shape columns [b - a, c - a] of the i-th triangle, used for the fixed cotangent weights. Throws
  // std::invalid_argument when a count differs, an index is out of range or a reference triangle is not counter-clockwise.
  Embedder(std::vector<FlatMesh> panels, std::vector<MatingEdges> mating, const std::vector<Eigen::Matrix2d>& reference,
           EmbedOptions options = {});
  ~Embedder();
  Embedder(Embedder&&) noexcept;
  Embedder& operator=(Embedder&&) noexcept;

  // `shapes[i]`: wanted shape of triangle i, as [b - a, c - a] up to a rotation. `start`: positions by panel, whose triangles
  // are not turned by more than half a turn against the result.
  Embedding embed(const std::vector<Eigen::Matrix2d>& shapes, const std::vector<Eigen::Matrix2Xd>& start) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace toile
