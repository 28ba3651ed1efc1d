#pragma once
// The cut line of one edge by itself, and the corners where two of them meet. The outline runs counter-clockwise.

#include <vector>

#include "cut/cut.h"
#include "cut/polygon.h"

namespace toile {

using Line = std::vector<OutlinePoint>;

struct OffsetEdge {
  int edge = 0;      // index into Piece::outline
  double width = 0;  // m, its allowance
  bool hem = false;
  Line sew;                      // the net edge without repeated points
  Line cut;                      // sew moved outwards by `width`; first and last are the feet beside the end points of `sew`
  Eigen::Vector2d first, last;   // unit directions of travel at both ends
  std::vector<Polygon> patches;  // what the cut line adds beyond the strips beside the segments, fans about their first point
};

OffsetEdge offset_edge(Line sew, double width, const AllowanceRules& rules);

// How the cut lines of two consecutive edges meet.
struct Joint {
  Line points;           // of the cut line, from the last kept point of `in.cut` to the first kept one of `out.cut`
  double in_end = 0;     // how far along `in.cut` it is kept, in points; beyond the last index when it was lengthened
  double out_begin = 0;  // from where `out.cut` is kept; below 0 when it was lengthened
  bool meets = true;     // false: the lines do not meet near the corner; `points` then leads back to the corner itself
  std::vector<Polygon> patches;
  std::optional<Eigen::Vector2d> in_trimmed, out_trimmed;  // where the strip of the last / first segment must end
};

Joint join(const OffsetEdge& in, const OffsetEdge& out, const AllowanceRules& rules);

// Where cut line `in`, lengthened by `reach` along `in_direction`, meets `out`, lengthened backwards, nearest to `corner`.
struct Meeting {
  Eigen::Vector2d at;
  double in_end = 0, out_begin = 0;  // as in Joint
};
std::optional<Meeting> meet(const Line& in, const Eigen::Vector2d& in_direction, const Line& out,
                            const Eigen::Vector2d& out_direction, const Eigen::Vector2d& corner, double reach);

// The corner of a hem: the cut line `side`, which runs towards `corner`, ends on the hem line; its reflection about the hem
// line (through `corner`, unit direction `along`, `inside` of it the piece) ends on `hem`, which starts beside `corner`. Empty
// when they do not meet within `reach`.
struct HemCorner {
  Line points;           // from the hem line to `hem`
  double side_end = 0;   // as Joint::in_end
  double hem_begin = 0;  // as Joint::out_begin
};
std::optional<HemCorner> mirror_at_hem(const Line& side, const Eigen::Vector2d& side_direction, const Line& hem,
                                       const Eigen::Vector2d& corner, const Eigen::Vector2d& along,
                                       const Eigen::Vector2d& inside, double reach);

}  // namespace toile
