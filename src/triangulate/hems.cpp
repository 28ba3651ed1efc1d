#include "triangulate/hems.h"

#include <algorithm>
#include <cmath>

#include "geometry/polyline.h"

namespace toile {
namespace {

// A side of the panel's boundary along a hem, and how far the hem is turned up there.
struct HemSide {
  Points<2> line;
  double depth = 0;
};

std::vector<HemSide> hem_sides(const Piece& piece, const PanelMesh& panel, double depth) {
  std::vector<HemSide> sides;
  const std::size_t n = panel.boundary.size();
  for (std::size_t i = 0; i < n; ++i) {
    // The side after vertex i lies on the edge of whichever end comes first in outline order.
    const BoundaryVertex& a = panel.boundary[i];
    const BoundaryVertex& b = panel.boundary[(i + 1) % n];
    const Edge& edge = piece.outline[static_cast<std::size_t>(panel.mirrored ? b.edge : a.edge)];
    const double turned_up = edge.seam_allowance.value_or(depth);
    if (edge.hem && turned_up > 0) sides.push_back({{panel.rest.col(a.vertex), panel.rest.col(b.vertex)}, turned_up});
  }
  return sides;
}

}  // namespace

GarmentMesh with_hems(const Pattern& pattern, GarmentMesh garment, double depth) {
  for (PanelMesh& panel : garment.panels) {
    panel.layers.resize(0);
    const auto sides = hem_sides(pattern.pieces[static_cast<std::size_t>(panel.piece)], panel, depth);
    if (sides.empty()) continue;
    panel.layers = Eigen::VectorXd::Ones(panel.triangles.cols());
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      const auto corner = panel.triangles.col(t);
      const Eigen::Vector2d a = panel.rest.col(corner(0));
      const Eigen::Vector2d b = panel.rest.col(corner(1));
      const Eigen::Vector2d c = panel.rest.col(corner(2));
      const Eigen::Vector2d centre = (a + b + c) / 3;
      const double width = std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()});
      double within = -1e9;
      for (const HemSide& side : sides) within = std::max(within, side.depth - nearest_on<2>(side.line, centre).distance);
      panel.layers(t) = 1 + std::clamp(within / width + 0.5, 0.0, 1.0);
    }
  }
  return garment;
}

}  // namespace toile
