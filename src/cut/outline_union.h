#pragma once
// The outline of many overlapping polygons, computed exactly.

#include <vector>

#include "cut/polygon.h"

namespace toile {

struct OutlineUnion {
  Polygon outer;               // counter-clockwise
  std::vector<Polygon> holes;  // clockwise
};

// `first` must be simple and counter-clockwise; each of `fans` is star-shaped about its first point. All must hang together.
OutlineUnion unite(const Polygon& first, const std::vector<Polygon>& fans);

}  // namespace toile
