#pragma once
// Two pieces that meet along one edge of each, drawn as one piece.

#include <utility>
#include <vector>

#include "draft/alike.h"
#include "garment/pattern.h"

namespace toile {

struct PieceJoin {
  int base = 0, other = 0;  // indices into the pattern; the base keeps its frame, name and grain line
  int base_edge = 0, other_edge = 0;
  bool reflected = false;                   // a copy of the one meets a copy of the other that is cut the other way over
  std::vector<std::pair<int, int>> copies;  // of base, of other; ascending
};

// Where an edge of the united piece comes from.
struct EdgeOrigin {
  bool of_base = true;
  int edge = 0;           // of that piece
  bool reversed = false;  // it runs the other way now
};

struct UnitedPiece {
  Piece piece;  // notches, lines, holes of both; copy i is the i-th pair of the join
  std::vector<EdgeOrigin> origin;
  Isometry lay;            // from the other piece's frame
  double edges_apart = 0;  // m, greatest distance between the two edges as they are laid on each other
  double grain_turn = 0;   // radians between the grain lines of both, up to a right angle; 0 when one has none
};

// The other piece is laid against the base so that both edges lie on each other as well as a motion does; the ends of what
// goes on beyond are drawn together in the middle. Edges that would have one name are numbered on.
UnitedPiece united_piece(const Pattern& pattern, const PieceJoin& join);

}  // namespace toile
