#pragma once
// Closed lines and what lies within what.

#include <vector>

#include "formats/svg_read/path.h"
#include "formats/svg_read/words.h"

namespace toile::svg {

// A closed line: one drawn so, or several open ones that meet.
struct Ring {
  Points<2> points;         // counter-clockwise, no repeated point
  std::vector<Bend> bends;  // by point
  Role role = Role::unknown;
  bool dashed = false;
  std::vector<std::size_t> lines;  // of the drawing
  int line = 0;                    // of the file
  double area = 0;                 // m^2
};

struct Box {
  Eigen::Vector2d low, high;
  explicit Box(const Points<2>& points) : low(points.front()), high(points.front()) {
    for (const Eigen::Vector2d& p : points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  bool within(const Box& other, double slack) const {
    return (low - other.low).minCoeff() >= -slack && (other.high - high).minCoeff() >= -slack;
  }
};

constexpr double touching = 5e-4;  // m, nearer than this is on a line

bool contains(const Points<2>& ring, const Eigen::Vector2d& at);
// Most of `inner` lies in `outer`, and none of it farther outside than `beside` metres.
bool is_within(const Ring& inner, const Ring& outer, double beside = 15e-3);
bool is_upright_rectangle(const Ring& ring);
// Counter-clockwise, with its area.
void orient(Ring& ring);

}  // namespace toile::svg
