#pragma once
// Edges of all pieces cut at the ends of seams, and which of the parts are divided alike.

#include <vector>

#include "garment/pattern.h"
#include "triangulate/seam_places.h"

namespace toile {

// Part of an edge between two neighbouring marks. Parts of one class get the same number of vertices.
struct Interval {
  int piece = 0, edge = 0;
  double begin = 0, end = 1;  // fractions of the edge, begin < end
  double length = 0;          // m
  int group = 0;              // class, numbered from 0
};

// In order of pieces, edges and fractions. An end of a seam on one of its edges is a mark on the other one too, and from there
// on, through every copy of the piece, wherever that edge is sewn. Throws BadInput("seam.ends-nearly-meet") when marks come so
// close together that the two sides of a seam no longer have equally many.
std::vector<Interval> intervals(const Pattern& pattern, const std::vector<SeamPlace>& seams);

}  // namespace toile
