#pragma once
// Tubes and cones of upright panels round the body of the synthetic skirt, as if they floated there.

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "edit/operation.h"
#include "style/synthetic_skirt.h"
#include "triangulate/triangulate.h"

namespace toile::testing {

struct Tube {
  double radius = 0.30, top = 1.20, bottom = 0.50;  // m, radius at the top
  int panels = 4;
  double flare = 0;       // growth of the radius with depth
  bool mirrored = false;  // the piece is drawn the other way over
  double turned = 0;      // radians, of the grain line
  double edge_length = 25e-3;
};

inline double radius_at(const Tube& tube, double height) { return tube.radius + tube.flare * (tube.top - height); }

inline Piece strip_of(const Tube& tube) {
  constexpr int steps = 24;
  const double slant = std::hypot(1.0, tube.flare), sine = tube.flare / slant, turn = 2 * std::numbers::pi / tube.panels;
  // Of the developed surface: `round` 0..1 across the panel.
  const auto at = [&](double round, double height) {
    const double r = radius_at(tube, height);
    if (sine < 1e-9) return Eigen::Vector2d(round * turn * r, height - tube.bottom);
    const double angle = (round - 0.5) * turn * sine, far = r / sine;
    return Eigen::Vector2d(far * std::sin(angle), -far * std::cos(angle));
  };
  Piece piece;
  piece.name = "strip";
  const auto edge = [&](const char* id, double round0, double height0, double round1, double height1, bool curved) {
    Edge drawn;
    drawn.id = id;
    const int count = curved && sine > 1e-9 ? steps : 1;
    for (int i = 0; i <= count; ++i) {
      const double t = static_cast<double>(i) / count;
      drawn.points.push_back({at(round0 + t * (round1 - round0), height0 + t * (height1 - height0)), i == 0 || i == count, {}});
    }
    piece.outline.push_back(std::move(drawn));
  };
  edge("hem", 0, tube.bottom, 1, tube.bottom, true);
  edge("side_right", 1, tube.bottom, 1, tube.top, false);
  edge("top", 1, tube.top, 0, tube.top, true);
  edge("side_left", 0, tube.top, 0, tube.bottom, false);
  piece.notches.push_back({"side_right", 0.25});
  piece.notches.push_back({"side_right", 0.9});
  const Eigen::Vector2d from = at(0.5, tube.bottom + 0.1), to = at(0.5, tube.top - 0.1);
  piece.grainline = Grainline{from, from + Eigen::Rotation2Dd(tube.turned) * (to - from)};
  if (tube.mirrored)
    piece.mirrored_quantity = tube.panels, piece.quantity = 0;
  else
    piece.quantity = tube.panels;
  return piece;
}

inline WornGarment worn(const Tube& tube) {
  const double slant = std::hypot(1.0, tube.flare), sine = tube.flare / slant, turn = 2 * std::numbers::pi / tube.panels;
  WornGarment garment;
  garment.pattern.name = "tube";
  garment.pattern.pieces = {strip_of(tube)};
  const char *right = tube.mirrored ? "side_left" : "side_right", *left = tube.mirrored ? "side_right" : "side_left";
  for (int i = 1; i <= tube.panels; ++i)
    garment.pattern.seams.push_back(
        {"side " + std::to_string(i), {"strip", i, right, 0, 1}, {"strip", i % tube.panels + 1, left, 1, 0}, false});
  garment.edge_length = tube.edge_length;
  garment.garment = sew(garment.pattern, triangulate(garment.pattern, {.edge_length = garment.edge_length}));
  garment.drape.resize(3, garment.garment.vertex_count);
  for (std::size_t p = 0; p < garment.garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.garment.panels[p];
    for (Eigen::Index v = 0; v < panel.rest.cols(); ++v) {
      const Eigen::Vector2d at = panel.rest.col(v);
      double round = 0, height = 0;
      if (sine < 1e-9) {
        round = at.x() / (turn * tube.radius) + (tube.mirrored ? 1 : 0);
        height = tube.bottom + at.y();
      } else {
        round = std::atan2(at.x(), -at.y()) / (turn * sine) + 0.5;
        height = tube.top - (at.norm() * sine - tube.radius) / tube.flare;
      }
      const double angle = (static_cast<double>(p) + round) * turn, r = radius_at(tube, height);
      garment.drape.col(garment.garment.welded[p](v)) << r * std::sin(angle), height, r * std::cos(angle);
    }
  }
  return garment;
}

inline const Body& body_in_tube() {
  static const Body one = make_body(elliptical_body({}));
  return one;
}

inline Target mixed_worn(const WornGarment& own, const WornGarment& other, EditArguments arguments) {
  arguments["with"] = "other";
  return find_operation("mix").apply(
      {own.pattern,
       own.garment,
       own.drape,
       body_in_tube(),
       {},
       [&](const std::string&, const Body&, const std::string&) { return std::make_shared<const WornGarment>(other); }},
      arguments);
}

inline Target mixed(const Tube& first, const Tube& second, const EditArguments& arguments) {
  return mixed_worn(worn(first), worn(second), arguments);
}

inline int findings(const Target& target, const std::string& code) {
  int count = 0;
  for (const Finding& finding : target.report.findings) count += finding.code == code;
  return count;
}

}  // namespace toile::testing
