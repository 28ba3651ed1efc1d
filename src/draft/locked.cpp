#include "draft/locked.h"

#include <Eigen/Dense>
#include <algorithm>
#include <set>

#include "geometry/polyline.h"

namespace toile {

std::vector<KeptDistance> kept_distances(const Pattern& pattern) {
  std::vector<KeptDistance> kept;
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p) {
    const Piece& piece = pattern.pieces[p];
    const Sides sides = sides_of(piece);
    for (std::size_t e = 0; e < piece.outline.size(); ++e) {
      if (!piece.outline[e].locked) continue;
      std::set<double> ends{0, 1};
      for (const Run& run : sides.runs)
        for (const Run::Part& part : run.parts)
          if (part.edge == static_cast<int>(e)) ends.insert({part.edge_begin, part.edge_end});
      const std::vector<double> at(ends.begin(), ends.end());
      const std::vector<Eigen::Vector2d> points = positions(piece.outline[e]);
      for (std::size_t i = 0; i < at.size(); ++i)
        for (std::size_t j = i + 1; j < std::min(at.size(), i + 3); ++j)
          kept.push_back({static_cast<int>(p), static_cast<int>(e), at[i], at[j],
                          (point_at<2>(points, at[j]) - point_at<2>(points, at[i])).norm()});
    }
  }
  return kept;
}

bool is_locked(const Piece& piece, const Run& run) {
  return std::any_of(run.parts.begin(), run.parts.end(),
                     [&](const Run::Part& part) { return piece.outline[static_cast<std::size_t>(part.edge)].locked; });
}

}  // namespace toile
