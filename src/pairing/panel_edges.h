#pragma once
// The outlines of all copies of all pieces as edges that can be sewn, each seen from the fabric's right side and hanging as it
// is worn.

#include <Eigen/Core>
#include <vector>

#include "garment/pattern.h"
#include "geometry/polyline.h"

namespace toile {

// A run of one edge of one copy. Walked with the panel on its left; mirrored copies are walked against their drawing.
struct PanelEdge {
  int panel = 0;                      // counts copies over all pieces
  int edge = 0;                       // index into Piece::outline
  double begin = 0, end = 1;          // fractions of that edge as it is walked; begin > end on mirrored copies
  double length = 0;                  // m
  Eigen::Vector2d along = {1, 0};     // unit, from its start to its end
  Eigen::Vector2d outward = {0, -1};  // unit, across the chord
  std::vector<double> heading;        // radians against the chord, at 8 places from start to end
  double angle = 0;                   // of the panel at the edge's start, radians
  double sure = 1;                    // of the upright, 0..1
  int next = 0, previous = 0;         // round the panel
  std::vector<double> notches;        // fractions of the run from its start
};

struct Panel {
  int piece = 0;
  int copy = 1;
  int first = 0, count = 0;  // of its edges; splitting appends others that are reached by `next`
  double area = 0, width = 0, height = 0;
  Eigen::Matrix2d turn = Eigen::Matrix2d::Identity();  // of the drawing, to hang as it is worn
  double sure = 1;                                     // of that
};

struct PanelEdges {
  std::vector<Panel> panels;
  std::vector<PanelEdge> edges;
};

// Panels of the pieces for which `sewn` is true (one flag a piece). Those of `bands` (likewise) are worn round the body,
// whichever way they are drawn: their long side lies.
PanelEdges panel_edges(const Pattern& pattern, const std::vector<bool>& sewn, const std::vector<bool>& bands);

// Cuts edge `index` at `shares` (ascending, 0 < share < 1, of the run from its start); returns the edges in its place in order.
std::vector<int> split_edge(const Pattern& pattern, PanelEdges& all, int index, const std::vector<double>& shares);

// The span as it is walked, and against that.
EdgeSpan span_of(const Pattern& pattern, const PanelEdges& all, int index);
EdgeSpan reversed(EdgeSpan span);

}  // namespace toile
