#pragma once
// A block of the file sorted by what its layers mean, in metres; nothing interpreted yet.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/dxf/drawing.h"
#include "formats/dxf_aama/texts.h"
#include "garment/pattern.h"
#include "geometry/polyline.h"

namespace toile::aama {

// One LINE or polyline.
struct Run {
  Points<2> points;
  bool closed = false;
  int line = 0;  // of the file
};

struct MarkedPoint {
  Eigen::Vector2d at;
  bool turn = false;  // layer 2; otherwise layer 3
};

struct DrawnNotch {
  Eigen::Vector2d at;
  NotchKind kind = NotchKind::slit;
  double depth = 0;                                     // m, 0: not given
  double width = 0;                                     // m
  Eigen::Vector2d direction = Eigen::Vector2d::Zero();  // unit, as the file has it; zero: not given
  int line = 0;
  bool from_line = false;  // drawn as a line: `at` may be either end of it
};

struct DrawnPiece {
  std::string name;
  std::string file;  // for places
  int line = 0;      // of the block
  PieceTexts texts;
  std::vector<Run> cut, sew, dense_cut, dense_sew, internal_lines, cut_outs, grain, mirror;
  std::vector<MarkedPoint> points;  // turn and curve points in file order
  std::vector<DrawnNotch> notches;
  std::vector<DrillHole> drill_holes;
  std::vector<std::pair<Eigen::Vector2d, int>> grade_rules;
  std::vector<Eigen::Vector2d> not_mirrored;  // where a label "NM" stands
  double tolerance = 2e-5;                    // m, for points that should coincide

  // "front.dxf:412, piece 'sleeve'"
  std::string place(std::optional<int> at_line = {}) const;
};

// Where a block is put by its INSERT: rotate and scale about `base`, then shift; then file units to metres.
struct Transform {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  double unit = 1;  // metres per file unit, for depths and widths
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return linear * p + shift; }
};
Transform transform_of(const dxf::Block& block, const std::vector<dxf::Entity>& entities, double unit);

// What was met and left out, for one finding each at the end: "SPLINE on layer 1" -> how often.
using LeftOut = std::map<std::string, int>;

// Layers the table does not know are kept as internal lines and counted in `unknown_layers`; entities that cannot be read on
// layers that matter, in `unread`.
DrawnPiece sort_by_layer(const dxf::Block& block, const Transform& to_metres, LeftOut& unknown_layers, LeftOut& unread);

}  // namespace toile::aama
