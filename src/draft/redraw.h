#pragma once
// From adjusted panels back to a pattern a cutter can use, and from that pattern back to the panels' rest shape.

#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct RedrawOptions {
  double curve_tolerance = 0.5e-3;     // m, curves are refit to the panel's boundary within this
  double congruence_tolerance = 1e-4;  // m, pieces (and halves) this alike are kept alike
};

struct Redrawn {
  Pattern pattern;             // same pieces, edges, notches, seams as the original; new geometry
  double max_deviation = 0;    // m, panel boundary to redrawn outline
  double symmetry = 0;         // m, worst departure of identical or mirrored pieces from each other
  double seam_mismatch = 0;    // m, worst departure of mating edges from their intended length ratio
  Report report;
};

// `garment` is the mesh of `original`; `rest` are its adjusted rest shapes.
Redrawn redraw(const Pattern& original, const GarmentMesh& garment, const RestShape& rest, const RedrawOptions& options = {});

// The rest shape of `garment`'s panels when cut from `pattern` (same pieces and edges as the pattern it was meshed from):
// boundary vertices at their arc-length place on the new outline, interior as rigid as possible to `like`.
RestShape rest_on_outlines(const Pattern& pattern, const GarmentMesh& garment, const RestShape& like);

// m, worst departure of a seam's two lengths from the ratio they have in `original`.
double seam_mismatch(const Pattern& original, const Pattern& redrawn);

}  // namespace toile
