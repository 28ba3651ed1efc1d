#pragma once
// Simulators whose answer is known, and the sheets they are tried on.

#include <Eigen/Dense>
#include <utility>

#include "adjust/adjust.h"
#include "draft/hand_made.h"

namespace toile {

// A rectangle, 24 by 60 cm.
inline HandMade sheet() {
  HandMade made;
  Piece piece;
  piece.name = "sheet";
  piece.outline = {edge("hem", {{0, 0}, {.24, 0}}), edge("right", {{.24, 0}, {.24, .6}}), edge("top", {{.24, .6}, {0, .6}}),
                   edge("left", {{0, .6}, {0, 0}})};
  made.pattern.pieces = {piece};
  made.grids = {{{{{0}, {1}, {2}, {3}}}, {6, 15, 6, 15}}};
  mesh(made);
  return made;
}

// Two of them side by side, the right one `ease` times as long as the left one where they are sewn together.
inline HandMade two_sheets(double ease) {
  HandMade made = sheet();
  made.pattern.pieces.push_back(made.pattern.pieces[0]);
  made.pattern.pieces[1].name = "other";
  for (Edge& e : made.pattern.pieces[1].outline)
    for (OutlinePoint& point : e.points) point.at.y() *= ease;
  made.grids.push_back(made.grids[0]);
  made.pattern.seams = {{"seam", {"sheet", 1, "right", 0, 1}, {"other", 1, "left", 1, 0}, false}};
  mesh(made);
  return made;
}

inline Eigen::Matrix3Xd in_space(const Eigen::Matrix2Xd& flat) {
  Eigen::Matrix3Xd at = Eigen::Matrix3Xd::Zero(3, flat.cols());
  at.topRows(2) = flat;
  return at;
}

inline Drape settled(Eigen::Matrix3Xd positions) {
  Drape drape;
  drape.positions = std::move(positions);
  drape.settled = true;
  return drape;
}

// t = A T: the sheet stretched as a whole. Gravity pulls the same whatever the panel's shape.
inline Simulate stretches_by(const Eigen::Matrix2d& a) {
  return [a](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double) {
    Eigen::Matrix2Xd flat = a * garment.panels[0].rest;
    flat.colwise() += Eigen::Vector2d(start.topRows(2).rowwise().mean() - flat.rowwise().mean());
    return settled(in_space(flat));
  };
}

inline Eigen::Matrix2d pull() {
  Eigen::Matrix2d a;
  a << .97, .03, .03, 1.12;
  return a;
}

// The source stretched by `a`, lengthened by `longer` and bent by a shear that grows downwards.
inline Target target_of(const HandMade& made, const Eigen::Matrix2d& a, bool with_source) {
  Target target;
  target.garment = made.garment;
  const Eigen::Matrix2Xd source = a * made.garment.panels[0].rest;
  if (with_source) target.source = in_space(source);
  Eigen::Matrix2d edit;
  edit << 1.05, .02, .02, 1.2;
  target.positions = in_space(edit * source);
  return target;
}

inline AdjustOptions exact() {
  AdjustOptions options;
  options.agreed_hausdorff = 1e-9;
  return options;
}

// Cloth that resists more the more it is pulled: the stretch depends on the rest shape.
inline Simulate hardens() {
  return [](const GarmentMesh& garment, const Eigen::Matrix3Xd& start, double) {
    const Eigen::Matrix2Xd& rest = garment.panels[0].rest;
    const double height = rest.row(1).maxCoeff() - rest.row(1).minCoeff();
    return stretches_by(Eigen::Vector2d(1 - .05 * height, 1 + .2 * height).asDiagonal())(garment, start, 0);
  };
}

}  // namespace toile
