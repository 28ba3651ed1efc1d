#include <stdexcept>
#include <vector>

#include "draft/interior.h"
#include "draft/places.h"
#include "draft/redraw.h"
#include "geometry/polyline.h"

namespace toile {

RestShape rest_on_outlines(const Pattern& pattern, const GarmentMesh& garment, const RestShape& like) {
  if (like.size() != garment.panels.size()) throw std::invalid_argument("rest_on_outlines: number of panels differs");
  const std::vector<std::vector<double>> places = places_on_outline(garment, like);
  RestShape rest;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    if (panel.piece < 0 || panel.piece >= static_cast<int>(pattern.pieces.size()) || like[p].cols() != panel.rest.cols())
      throw std::invalid_argument("rest_on_outlines: panel '" + panel.name + "' does not belong to the pattern");
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    std::vector<int> boundary;
    Eigen::Matrix2Xd targets(2, static_cast<Eigen::Index>(panel.boundary.size()));
    for (std::size_t i = 0; i < panel.boundary.size(); ++i) {
      const auto edge = static_cast<std::size_t>(panel.boundary[i].edge);
      if (edge >= piece.outline.size())
        throw std::invalid_argument("rest_on_outlines: piece '" + piece.name + "' has fewer edges than its mesh");
      boundary.push_back(panel.boundary[i].vertex);
      targets.col(static_cast<Eigen::Index>(i)) = point_at<2>(positions(piece.outline[edge]), places[p][i]);
    }
    LaidPanel laid = lay_panel(panel.triangles, like[p], panel.rest, boundary, as_drawn(panel, targets));
    if (laid.inverted > 0)
      throw BadInput({"redraw.folded-panel", Severity::error, "panel '" + panel.name + "'",
                      std::to_string(laid.inverted) + " triangles fold over in the new outline",
                      "the edit may be too large for this piece: make it in smaller steps, or use a finer mesh",
                      Fault::cannot_create});
    rest.push_back(std::move(laid.at));
  }
  return rest;
}

double seam_mismatch(const Pattern& original, const Pattern& redrawn) {
  double worst = 0;
  for (const Seam& seam : original.seams) {
    const double ratio = span_length(original, seam.a) / span_length(original, seam.b);
    worst = std::max(worst, std::abs(span_length(redrawn, seam.a) - ratio * span_length(redrawn, seam.b)));
  }
  return worst;
}

}  // namespace toile
