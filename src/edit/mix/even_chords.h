#pragma once
// Cuts across panels made fit to be drawn: alike on copies of a piece and on pieces that are alike, meeting at seams, smooth.

#include <vector>

#include "edit/mix/parting.h"

namespace toile {

// Copies of one piece that are cut alike, or alike not at all.
struct PieceGroup {
  int piece = 0;              // index into the pattern
  std::vector<int> copies;    // ascending
  std::vector<int> panels;    // by copy
  bool beyond = false;        // where they are, when they are not cut
  std::vector<Chord> chords;  // ends and points shared by the copies; each from the earlier end on the outline
  std::vector<std::vector<Chord>> copy_chords;  // [copy][chord]: loop and rank of that copy
  std::vector<std::vector<bool>> turned;        // [copy][chord]: it runs against the order of the loop
};

// In the order of the pattern's pieces.
std::vector<PieceGroup> even_chords(const EditInput& input, const Parting& parting);

// A smooth curve through the points, which keeps their ends; two points where they are straight to within 1.5 mm.
std::vector<Eigen::Vector2d> smooth_curve(const std::vector<Eigen::Vector2d>& points);

}  // namespace toile
