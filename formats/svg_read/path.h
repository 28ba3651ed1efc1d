#pragma once
// Path data and basic shapes as lines and cubic curves, and those as points.

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "formats/svg_read/element.h"
#include "formats/svg_read/numbers.h"
#include "geometry/polyline.h"

namespace toile::svg {

struct Segment {
  bool curve = false;
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d c1 = Eigen::Vector2d::Zero(), c2 = Eigen::Vector2d::Zero();  // of a curve
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
};

struct SubPath {
  std::vector<Segment> segments;
  bool closed = false;  // by "z", or a shape that is
};

struct PathData {
  std::vector<SubPath> parts;
  bool broken = false;      // something could not be read; what stands before it is there
  bool not_finite = false;  // a number beyond 1e300 or so
  std::size_t at = 0;       // character where it breaks off
};

// All commands of SVG 1.1, also with repeats left out and arc flags glued together.
PathData path_of(std::string_view data);

// rect, circle, ellipse, line, polyline, polygon or path; lengths in user units.
PathData shape_of(const Element& element);
bool is_shape(const Element& element);

// What is known of a point: nothing (a vertex of straight lines alone), that it is a corner, that it is none.
enum class Bend : signed char { unknown, smooth, corner };

// A sub-path as points, sampled at equal arc length within `tolerance` of the curve; straight runs are two points.
struct Sampled {
  Points<2> points;         // a closed one does not repeat its first point
  std::vector<Bend> bends;  // by point
  bool closed = false;
  bool has_curves = false;
};

// `to_metres` is applied first; `tolerance` in metres. A part whose ends meet is closed. In a part with curves, a corner is
// where the tangents of two segments differ by 10 degrees or more. `as_drawn` keeps vertices that bend nothing.
Sampled sampled(const SubPath& part, const Affine& to_metres, double tolerance, bool as_drawn = false);

}  // namespace toile::svg
