#pragma once
// A pattern as GarmentCode has it: every copy a panel of its own, and every stitch the whole of two edges.

#include <string>
#include <vector>

#include "formats/garmentcode/curve_fit.h"
#include "garment/pattern.h"

namespace toile {

struct PanelEdge {
  std::string id;  // of the edge it is, or is part of
  bool whole = true;
  std::vector<Eigen::Vector2d> points;  // m, ends included
  FittedCurve curve;
};

struct FlatPanel {
  std::string name;
  int piece = 0, copy = 1;
  std::vector<PanelEdge> edges;  // counter-clockwise; a mirrored copy as it is cut
};

struct Stitch {
  int panel_a = 0, edge_a = 0, panel_b = 0, edge_b = 0;
  bool same_way = false;  // beginning to beginning, as the edges run
  int seam = 0;
};

struct OneToOne {
  std::vector<FlatPanel> panels;
  std::vector<Stitch> stitches;
};

// Cuts edges where a seam begins or ends inside them, where a curve departs from one curve by more than `tolerance` (m), where
// an edge ends at its own beginning, and what is sewn to such a place likewise. Throws std::invalid_argument for a seam that
// names what is not there.
OneToOne one_to_one(const Pattern& pattern, double tolerance);

}  // namespace toile
