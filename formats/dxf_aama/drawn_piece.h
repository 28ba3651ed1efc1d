#pragma once
// A block of the file sorted by what its layers mean, in metres; nothing interpreted yet.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "formats/dxf/drawing.h"
#include "formats/dxf_aama/layers.h"
#include "formats/dxf_aama/texts.h"
#include "garment/pattern.h"
#include "garment/report.h"
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

// A text "# 12": the points there move by rule 12 of the grade rule table.
struct RuleMark {
  Eigen::Vector2d at;
  int rule = 0;
  Role role = Role::turn_point;  // of the text's layer
};

// What was met and left out, for one finding each at the end: "SPLINE on layer 1" -> how often.
using LeftOut = std::map<std::string, int>;

struct DrawnPiece {
  std::string name;
  std::string file;  // for places
  int line = 0;      // of the block
  PieceTexts texts;
  std::vector<Run> cut, sew, dense_cut, dense_sew, internal_lines, cut_outs, dense_internal_lines, dense_cut_outs;
  std::vector<Run> grain, mirror, grade_reference;
  std::vector<MarkedPoint> points;  // turn and curve points in file order
  std::vector<DrawnNotch> notches;
  std::vector<DrillHole> drill_holes;
  std::vector<RuleMark> grade_rules;
  std::vector<Eigen::Vector2d> not_mirrored;             // where a label "NM" stands
  double tolerance = 2e-5;                               // m, for points that should coincide
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();  // of the Transform it came by
  double unit = 1;                                       // m per file unit

  // "front.dxf:412, piece 'sleeve'"
  std::string place(std::optional<int> at_line = {}) const;
};

// Where a block is put by its INSERT: rotate and scale about `base`, then shift; then file units to metres.
struct Transform {
  Eigen::Matrix2d linear = Eigen::Matrix2d::Identity();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  double unit = 1;     // metres per file unit, for depths and widths
  double chord = .02;  // file units, how far curves may be from their chords
  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const { return linear * p + shift; }
};
Transform transform_of(const dxf::Block& block, const std::vector<dxf::Entity>& entities, double unit, double chord);

// What sort_by_layer met beside what it could sort.
struct Sorted {
  LeftOut unknown_layers;  // their lines are kept as internal lines
  LeftOut unread;          // entities of kinds that cannot be read
  LeftOut not_kept;        // read, but a Pattern has no place for them: "LINE on layer 9 (stripe reference lines)"
};

// `entities` as dxf::exploded gives them: no INSERT among them.
DrawnPiece sort_by_layer(const dxf::Block& block, const std::vector<dxf::Entity>& entities, const Transform& to_metres,
                         Sorted& sorted);

// What the piece has more of than any pattern piece has, in words; reading it would take minutes. Null: nothing.
const char* too_much_in(const DrawnPiece& piece);

// Findings "aama.unknown-layer", "aama.unsupported-entity" and "aama.not-kept" about the file.
void report_left_out(const Sorted& sorted, const std::string& file, Report& report);

}  // namespace toile::aama
