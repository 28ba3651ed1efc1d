#pragma once
// One line drawn twice, with other vertices: which place of the one is which of the other.

#include "formats/dxf_aama/chains.h"

namespace toile::aama {

// Maps places of `from` to `to`, both without repeated points: corners to corners where they have as many, in between by arc
// length; closed lines without corners from their most alike vertex on.
class LineMatch {
 public:
  LineMatch(const Chain& from, const Chain& to);
  Eigen::Vector2d operator()(const Eigen::Vector2d& on_from) const;

 private:
  Points<2> from_, to_;                  // closed lines repeat their first point
  std::vector<double> from_at_, to_at_;  // anchors, fractions of arc length, ascending from 0 to 1
};

}  // namespace toile::aama
