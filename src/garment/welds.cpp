#include "garment/welds.h"

#include <algorithm>
#include <map>
#include <utility>

namespace toile {

std::vector<BoundarySegment> boundary_segments(const GarmentMesh& garment) {
  std::vector<BoundarySegment> segments;
  std::map<std::pair<int, int>, std::vector<int>> by_welded_ends;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    for (std::size_t i = 0; i < panel.boundary.size(); ++i) {
      const BoundaryVertex& a = panel.boundary[i];
      const BoundaryVertex& b = panel.boundary[(i + 1) % panel.boundary.size()];
      // The corner that ends an edge is stored as the start of the next one.
      const BoundaryVertex& inner = panel.mirrored ? b : a;
      const BoundaryVertex& outer = panel.mirrored ? a : b;
      const double far = outer.edge == inner.edge && outer.at > inner.at ? outer.at : 1.0;
      BoundarySegment segment{static_cast<int>(p), a.vertex, b.vertex, inner.edge, inner.at, far, {}};
      if (panel.mirrored) std::swap(segment.begin, segment.end);
      const int u = garment.welded[p](a.vertex), v = garment.welded[p](b.vertex);
      by_welded_ends[{std::min(u, v), std::max(u, v)}].push_back(static_cast<int>(segments.size()));
      segments.push_back(segment);
    }
  }
  for (const auto& [ends, together] : by_welded_ends)
    for (const int s : together)
      for (const int other : together)
        if (other != s) segments[static_cast<std::size_t>(s)].mates.push_back(other);
  return segments;
}

}  // namespace toile
