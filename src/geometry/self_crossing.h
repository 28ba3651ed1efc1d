#pragma once
// Whether a closed polygon is simple.

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace toile {

// Two sides of a closed polygon, by the index of their first corner.
struct SelfCrossing {
  int first = 0, second = 0;
  bool operator==(const SelfCrossing&) const = default;
};

// The first pair of sides that cross, touch without being neighbours, or, being neighbours, fold back onto each other; {0, 0}
// with fewer than three corners; empty when the polygon is simple. The polygon is given without repeated end and without two
// equal points in a row. Sides within `touching` of each other touch; at 0 it is exact: rounding neither hides nor invents a
// crossing.
std::optional<SelfCrossing> first_self_crossing(const std::vector<Eigen::Vector2d>& loop, double touching = 0);

}  // namespace toile
