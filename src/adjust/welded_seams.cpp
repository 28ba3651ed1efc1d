#include "adjust/welded_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "garment/welds.h"

namespace toile {
namespace {

double length(const Eigen::Matrix2Xd& at, const BoundarySegment& segment) {
  return (at.col(segment.to) - at.col(segment.from)).norm();
}

struct SeamLengths {
  double a = 0, b = 0;                // now
  double a_source = 0, b_source = 0;  // in the garment's own rest shape
};

// By (panel, edge) of both sides.
std::map<std::array<int, 4>, SeamLengths> seam_lengths(const GarmentMesh& garment, const RestShape& rest) {
  const std::vector<BoundarySegment> segments = boundary_segments(garment);
  std::map<std::array<int, 4>, SeamLengths> lengths;
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (const int mate : segments[s].mates) {
      if (mate < static_cast<int>(s)) continue;
      const BoundarySegment &a = segments[s], &b = segments[static_cast<std::size_t>(mate)];
      const auto pa = static_cast<std::size_t>(a.panel), pb = static_cast<std::size_t>(b.panel);
      SeamLengths& sum = lengths[{a.panel, a.edge, b.panel, b.edge}];
      sum.a += length(rest[pa], a);
      sum.b += length(rest[pb], b);
      sum.a_source += length(garment.panels[pa].rest, a);
      sum.b_source += length(garment.panels[pb].rest, b);
    }
  return lengths;
}

}  // namespace

std::vector<MatingEdges> mating_edges(const GarmentMesh& garment) {
  const std::vector<BoundarySegment> segments = boundary_segments(garment);
  std::vector<MatingEdges> mating;
  for (std::size_t s = 0; s < segments.size(); ++s)
    for (const int mate : segments[s].mates) {
      if (mate < static_cast<int>(s)) continue;
      const BoundarySegment &a = segments[s], &b = segments[static_cast<std::size_t>(mate)];
      const double la = length(garment.panels[static_cast<std::size_t>(a.panel)].rest, a);
      const double lb = length(garment.panels[static_cast<std::size_t>(b.panel)].rest, b);
      mating.push_back({a.panel, a.from, a.to, b.panel, b.from, b.to, la / lb});
    }
  return mating;
}

std::vector<bool> eased_panels(const GarmentMesh& garment, double tolerance) {
  std::vector<bool> eased(garment.panels.size(), false);
  for (const auto& [sides, sum] : seam_lengths(garment, rest_shape(garment)))
    if (std::abs(sum.a / sum.b - 1) > tolerance)
      eased[static_cast<std::size_t>(sides[0])] = eased[static_cast<std::size_t>(sides[2])] = true;
  return eased;
}

double seam_mismatch(const GarmentMesh& garment, const RestShape& rest) {
  double worst = 0;
  for (const auto& [sides, sum] : seam_lengths(garment, rest))
    worst = std::max(worst, std::abs(sum.a - sum.a_source / sum.b_source * sum.b));
  return worst;
}

}  // namespace toile
