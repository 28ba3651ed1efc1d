#include "triangulate/mating.h"

#include "geometry/polyline.h"
#include "triangulate/stitching.h"

namespace toile {

std::vector<MatingEdges> mating_edges(const Pattern& pattern, const GarmentMesh& garment) {
  std::vector<Eigen::Matrix2Xd> drawn;  // [panel]: boundary vertices at their place on the outline
  for (const PanelMesh& panel : garment.panels) {
    Eigen::Matrix2Xd places = Eigen::Matrix2Xd::Zero(2, panel.rest.cols());
    for (const BoundaryVertex& v : panel.boundary) {
      const Edge& edge = pattern.pieces[static_cast<std::size_t>(panel.piece)].outline[static_cast<std::size_t>(v.edge)];
      places.col(v.vertex) = point_at<2>(positions(edge), v.at);
    }
    drawn.push_back(std::move(places));
  }
  const auto chord = [&](int panel, int from, int to) {
    const Eigen::Matrix2Xd& places = drawn[static_cast<std::size_t>(panel)];
    return (places.col(to) - places.col(from)).norm();
  };
  std::vector<MatingEdges> edges;
  for (const Mating& m : matings(pattern, panel_loops(garment.panels)))
    for (std::size_t i = 1; i < m.a.size(); ++i) {
      const double ratio = chord(m.panel_a, m.a[i - 1], m.a[i]) / chord(m.panel_b, m.b[i - 1], m.b[i]);
      edges.push_back({m.panel_a, m.a[i - 1], m.a[i], m.panel_b, m.b[i - 1], m.b[i], ratio});
    }
  return edges;
}

}  // namespace toile
