#pragma once
// Pieces of a sewn garment made into one piece: pattern and mesh, no stitches left between them.

#include <vector>

#include "edit/mix/united_piece.h"
#include "garment/mesh.h"

namespace toile {

struct United {
  Pattern pattern;
  GarmentMesh garment;                  // the same triangles, panel by panel; rest roughly, as the outlines were put together
  std::vector<int> vertex;              // [garment vertex] -> that of the garment before
  std::vector<int> seam;                // [seam of the pattern] -> that of the pattern before
  std::vector<Eigen::Matrix2d> shapes;  // rest shape of every triangle as it was before
  double edges_apart = 0;               // m, as in UnitedPiece
  double grain_turn = 0;                // radians
  int piece = 0;                        // index of the united piece
};

// `shapes`: rest shape of the garment's triangles, any. The seams between the two edges are dropped, all others go on.
// Copies of a piece that are not joined stay a piece of their own.
United unite(const Pattern& pattern, const GarmentMesh& garment, const std::vector<Eigen::Matrix2d>& shapes,
             const PieceJoin& join);

}  // namespace toile
