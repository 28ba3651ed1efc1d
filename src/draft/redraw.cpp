#include "draft/redraw.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "draft/carry.h"
#include "draft/interior.h"
#include "draft/outline_fit.h"
#include "draft/places.h"
#include "garment/units.h"
#include "garment/welds.h"
#include "geometry/polyline.h"

namespace toile {
namespace {

constexpr double seam_limit = 0.2e-3;  // m, what a seam may be off before it is worth a warning

void check_belongs(const Pattern& original, const GarmentMesh& garment, const RestShape& rest) {
  if (rest.size() != garment.panels.size()) throw std::invalid_argument("redraw: number of panels differs");
  for (std::size_t p = 0; p < rest.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    if (rest[p].cols() != panel.rest.cols())
      throw std::invalid_argument("redraw: vertex count of '" + panel.name + "' differs");
    if (!rest[p].allFinite()) throw std::invalid_argument("redraw: rest shape of '" + panel.name + "' is not finite");
    if (panel.piece < 0 || panel.piece >= static_cast<int>(original.pieces.size()))
      throw std::invalid_argument("redraw: panel '" + panel.name + "' belongs to no piece");
    for (const BoundaryVertex& vertex : panel.boundary)
      if (vertex.edge < 0 ||
          vertex.edge >= static_cast<int>(original.pieces[static_cast<std::size_t>(panel.piece)].outline.size()))
        throw std::invalid_argument("redraw: panel '" + panel.name + "' lies on an edge its piece does not have");
  }
}

// The panels' boundaries in their pieces' frames, each panel turned back to where its piece was drawn.
std::vector<PanelOutline> panel_outlines(const Pattern& original, const GarmentMesh& garment, const RestShape& rest) {
  const std::vector<std::vector<double>> places = places_on_outline(garment, rest);
  std::vector<PanelOutline> outlines;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Eigen::Matrix2Xd drawn = as_drawn(panel, panel.rest);
    const Eigen::Matrix2Xd now = laid_on(drawn, panel.triangles, as_drawn(panel, rest[p]));
    const std::size_t count = panel.boundary.size();
    PanelOutline outline;
    outline.piece = panel.piece;
    outline.edges = static_cast<int>(original.pieces[static_cast<std::size_t>(panel.piece)].outline.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto at = [&](std::size_t k) { return drawn.col(panel.boundary[k % count].vertex); };
      const double stands_for = ((at(i + 1) - at(i)).norm() + (at(i + count - 1) - at(i)).norm()) / 2;
      outline.samples.push_back({panel.boundary[i].edge, places[p][i], now.col(panel.boundary[i].vertex), stands_for});
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

// m, by edge: how far the panel's boundary is off the outline once it is laid on it as well as it goes.
std::vector<double> deviation(const PanelOutline& panel, const Piece& piece) {
  const auto count = static_cast<Eigen::Index>(panel.samples.size());
  std::vector<Points<2>> edges;
  for (const Edge& edge : piece.outline) edges.push_back(positions(edge));
  Eigen::Matrix2Xd from(2, count), to(2, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const PanelOutline::Sample& sample = panel.samples[static_cast<std::size_t>(i)];
    from.col(i) = sample.point;
    to.col(i) = point_at<2>(edges[static_cast<std::size_t>(sample.edge)], sample.at);
  }
  const Eigen::Vector2d a = from.rowwise().mean(), b = to.rowwise().mean();
  const Eigen::Matrix2d covariance = (to.colwise() - b) * (from.colwise() - a).transpose();
  const double angle = std::atan2(covariance(1, 0) - covariance(0, 1), covariance(0, 0) + covariance(1, 1));
  const Eigen::Matrix2d turn = Eigen::Rotation2Dd(angle).toRotationMatrix();
  std::vector<double> worst(edges.size(), 0.0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto edge = static_cast<std::size_t>(panel.samples[static_cast<std::size_t>(i)].edge);
    const Eigen::Vector2d laid = turn * (from.col(i) - a) + b;
    worst[edge] = std::max(worst[edge], nearest_on<2>(edges[edge], laid).distance);
  }
  return worst;
}

// Points along the redrawn run, in the frame of its shape and in the direction of the shape's run.
std::vector<Eigen::Vector2d> run_points(const Piece& redrawn, const Run& run, const Lay& lay) {
  std::vector<Eigen::Vector2d> points;
  const auto add = [&](const Run::Part& part, double u) {
    const double at = part.edge_begin + u * (part.edge_end - part.edge_begin);
    points.push_back(lay.to_shape(point_at<2>(positions(redrawn.outline[static_cast<std::size_t>(part.edge)]), at)));
  };
  add(run.parts.front(), 0);
  for (const double u : {.25, .5, .75})
    if (!run.straight) add(run.parts.front(), u);
  add(run.parts.back(), 1);
  if (lay.reversed) std::reverse(points.begin(), points.end());
  return points;
}

// m, how far congruent pieces, and halves, are from each other.
double asymmetry(const Pattern& original, const Pattern& redrawn, const Likeness& likeness) {
  double worst = 0;
  for (const SharedShape& shape : likeness.shapes) {
    const int count = static_cast<int>(shape.sides.runs.size());
    std::vector<std::vector<Eigen::Vector2d>> first(static_cast<std::size_t>(count));
    for (const int p : shape.pieces) {
      const Sides sides = sides_of(original.pieces[static_cast<std::size_t>(p)]);
      const Lay& lay = likeness.lays[static_cast<std::size_t>(p)];
      for (int i = 0; i < count; ++i) {
        auto& other = first[static_cast<std::size_t>(run_of(lay, i, count))];
        const auto mine = run_points(redrawn.pieces[static_cast<std::size_t>(p)], sides.runs[static_cast<std::size_t>(i)], lay);
        if (p == shape.pieces.front()) other = mine;
        for (std::size_t k = 0; k < mine.size() && k < other.size(); ++k) worst = std::max(worst, (mine[k] - other[k]).norm());
      }
    }
    for (int r = 0; shape.mirror && r < count; ++r) {
      const auto& mine = first[static_cast<std::size_t>(r)];
      const auto& twin = first[static_cast<std::size_t>((((*shape.mirror - r) % count) + count) % count)];
      for (std::size_t k = 0; k < mine.size(); ++k) {
        const Eigen::Vector2d& other = twin[mine.size() - 1 - k];
        worst = std::max(worst, (mine[k] - Eigen::Vector2d(-other.x(), other.y())).norm());
      }
    }
  }
  return worst;
}

// Marks inside the pieces, carried by the mean of a piece's panels laid into its new outline.
void carry_all_marks(Pattern& redrawn, const GarmentMesh& garment, const RestShape& rest) {
  for (std::size_t piece = 0; piece < redrawn.pieces.size(); ++piece) {
    Piece& made = redrawn.pieces[piece];
    if (made.internal_lines.empty() && made.drill_holes.empty() && !made.grainline) continue;
    const PanelMesh* first = nullptr;
    const Eigen::Matrix2Xd* first_rest = nullptr;
    for (std::size_t p = 0; p < garment.panels.size() && !first; ++p)
      if (garment.panels[p].piece == static_cast<int>(piece)) {
        first = &garment.panels[p];
        first_rest = &rest[p];
      }
    if (!first) continue;
    std::vector<int> boundary;
    Eigen::Matrix2Xd targets(2, static_cast<Eigen::Index>(first->boundary.size()));
    for (std::size_t i = 0; i < first->boundary.size(); ++i) {
      const BoundaryVertex& vertex = first->boundary[i];
      boundary.push_back(vertex.vertex);
      targets.col(static_cast<Eigen::Index>(i)) =
          point_at<2>(positions(made.outline[static_cast<std::size_t>(vertex.edge)]), vertex.at);
    }
    const LaidPanel laid = lay_panel(first->triangles, *first_rest, first->rest, boundary, as_drawn(*first, targets));
    carry_marks(made, first->triangles, as_drawn(*first, first->rest), as_drawn(*first, laid.at));
  }
}

}  // namespace

Redrawn redraw(const Pattern& original, const GarmentMesh& garment, const RestShape& rest, const RedrawOptions& options) {
  check_belongs(original, garment, rest);
  Redrawn result;
  const std::vector<PanelOutline> panels = panel_outlines(original, garment, rest);
  const Likeness likeness =
      still_alike(original, find_likeness(original, options.congruence_tolerance), panels, options, result.report);
  FittedOutlines fitted = fit_outlines(original, likeness, panels, options);
  result.pattern = original;
  for (std::size_t p = 0; p < result.pattern.pieces.size(); ++p)
    result.pattern.pieces[p].outline = std::move(fitted.outlines[p]);
  carry_all_marks(result.pattern, garment, rest);

  for (const PanelOutline& panel : panels) {
    const Piece& piece = result.pattern.pieces[static_cast<std::size_t>(panel.piece)];
    const std::vector<double> off = deviation(panel, piece);
    for (const double edge : off) result.max_deviation = std::max(result.max_deviation, edge);
  }
  if (result.max_deviation > options.curve_tolerance)
    result.report.note(
        "redraw.outline-off-panel", {},
        "outlines are up to " + in_mm(result.max_deviation) + " off the adjusted panels, to stay straight and alike");
  result.symmetry = asymmetry(original, result.pattern, likeness);
  result.seam_mismatch = seam_mismatch(original, result.pattern);
  if (result.seam_mismatch > seam_limit)
    result.report.warn("redraw.seam-not-trued", {},
                       "the two sides of a seam differ by " + in_mm(result.seam_mismatch, 2) + " from how they were drawn",
                       "compare the lengths in the report and even them out by hand");
  return result;
}

}  // namespace toile
