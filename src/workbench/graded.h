#pragma once
// One pattern in several sizes: the same points in each, and what every point moves from size to size.

#include <string>
#include <vector>

#include "garment/pattern.h"

namespace toile {

// `sizes`, one pattern each with the same pieces and edges in the same order, with as many points on every edge: those of the
// size that has most there, at their shares of its arc length. Corners stay, straight edges too; a curve moves by no more than
// its chords were off. Throws std::invalid_argument when pieces or edges differ.
std::vector<Pattern> with_same_points(std::vector<Pattern> sizes);

// What a turn point does from size to size: its place in each less that in the base, m.
struct PointGrade {
  std::string piece, edge;             // the edge that starts there
  std::vector<Eigen::Vector2d> moves;  // by size; the base's is zero
};
std::vector<PointGrade> turn_point_grades(const std::vector<Pattern>& sizes, std::size_t base = 0);

}  // namespace toile
