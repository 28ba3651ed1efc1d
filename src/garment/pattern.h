#pragma once
// A sewing pattern as a pattern maker means it: pieces with named edges between turn points, and the seams that join them.
// Net (sew) line throughout; the cut line is made by cut/ from the seam allowances. Metres; pattern axes x right, y up.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace toile {

struct OutlinePoint {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  bool turn = false;              // a corner (AAMA layer 2); otherwise a curve point (layer 3)
  std::optional<int> grade_rule;  // number in the grade rule table
  bool operator==(const OutlinePoint&) const = default;
};

// One run of the outline from turn point to turn point, both included; the next edge starts where this one ends.
// Two points: a straight edge, and straight it stays.
struct Edge {
  std::string id;                        // unique in its piece: "hem", "side_left"; readers number unnamed ones "e0", "e1", ...
  std::vector<OutlinePoint> points;      // at least two, in outline order
  std::optional<double> seam_allowance;  // m; absent: the cut sheet's default
  bool hem = false;                      // turned up, not sewn to another edge: takes the cut sheet's hem allowance
  bool locked = false;                   // the adjustment may move and turn it, but not change its shape
  bool operator==(const Edge&) const = default;
};

// Part of an edge by fraction of its arc length. begin > end runs against the edge's own direction.
struct EdgeSpan {
  std::string piece;
  int copy = 1;  // 1 .. copies(piece)
  std::string edge;
  double begin = 0;
  double end = 1;
  bool operator==(const EdgeSpan&) const = default;
};

enum class NotchKind { slit, v, t, castle, check, u };

// A notch on the net line, at `at` of the arc length of `edge`; it points from the cut line inwards.
struct Notch {
  std::string edge;
  double at = 0;
  NotchKind kind = NotchKind::slit;
  double depth = 4e-3;  // m
  double width = 0;     // m, 0 for a slit
  bool operator==(const Notch&) const = default;
};

struct InternalLine {
  std::vector<Eigen::Vector2d> points;
  bool cut_out = false;  // AAMA layer 11 instead of 8
  bool operator==(const InternalLine&) const = default;
};

struct DrillHole {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double diameter = 0;  // m
  bool operator==(const DrillHole&) const = default;
};

struct Grainline {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::UnitY();
  bool operator==(const Grainline&) const = default;
};

// Where a copy of a piece starts before it is sewn: X3 = rotation * (x, y, 0) + translation, body frame (metres, Y up, floor
// y = 0, faces +Z, wearer's left = +X). The panel's outside is the side from which its outline is counter-clockwise, i.e.
// rotation * +Z.
struct Placement {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  bool operator==(const Placement&) const = default;
};

// Where a copy sits when there is no 3D placement: on a part of the body, at an angle round it (0 = centre front, +90 degrees
// = wearer's left), its grain upright, its topmost point at `height` (metres above the floor) or at a landmark of the body.
struct BodyPart {
  std::string part = "trunk";   // trunk, arm.L, arm.R, leg.L, leg.R
  double angle = 0;             // radians
  std::string level = "waist";  // landmark whose height the top of the piece takes
  double drop = 0;              // m, how far below that level
  bool grain_round = false;     // the grain runs round the part (a waistband, a cuff) instead of along it
  bool operator==(const BodyPart&) const = default;
};

struct Piece {
  std::string name;           // unique in the pattern
  int quantity = 1;           // copies cut as drawn
  int mirrored_quantity = 0;  // further copies cut mirrored (about the y axis)
  std::string material;
  std::vector<Edge> outline;  // one closed loop, counter-clockwise seen from the fabric's right side
  std::vector<Notch> notches;
  std::vector<InternalLine> internal_lines;
  std::vector<DrillHole> drill_holes;
  std::optional<Grainline> grainline;
  std::vector<std::string> annotations;
  bool sewn = true;  // false: lies on other pieces or binds their edges (pocket, facing, interlining); cut, but not draped
  std::optional<int> layer;  // where several pieces are sewn into one seam: 0 lies nearest the body; absent: later seams outside
  std::vector<std::optional<Placement>> placement;  // by copy; empty: none known
  std::vector<std::optional<BodyPart>> body_part;   // by copy; empty: none known
  bool operator==(const Piece&) const = default;
};

// Joins two runs of edges of equal or (ease, gathers) different length, right side to right side: the start of `a` meets the
// start of `b` as the spans are directed.
struct Seam {
  std::string name;
  EdgeSpan a, b;
  bool right_to_wrong = false;
  bool operator==(const Seam&) const = default;
};

struct Pattern {
  std::string name;
  std::string style;
  std::string sample_size;
  std::vector<Piece> pieces;
  std::vector<Seam> seams;
  std::string fabric;
  bool operator==(const Pattern&) const = default;
};

int copies(const Piece&);                  // quantity + mirrored_quantity
bool is_mirrored(const Piece&, int copy);  // copy counts from 1; the first `quantity` are as drawn
const Piece* find_piece(const Pattern&, const std::string& name);
const Edge* find_edge(const Piece&, const std::string& id);
std::vector<Eigen::Vector2d> positions(const Edge&);
double length(const Edge&);
double span_length(const Pattern&, const EdgeSpan&);     // throws std::invalid_argument when the span names nothing
double signed_area(const Piece&);                        // > 0 when counter-clockwise
bool is_straight(const Edge&, double tolerance = 1e-5);  // m, every point within `tolerance` of the chord

}  // namespace toile
