#pragma once
// From adjusted panels back to a pattern a cutter can use, and from that pattern back to the panels' rest shape.

#include "garment/mesh.h"
#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct RedrawOptions {
  double curve_tolerance = 0.5e-3;     // m, curves are refit to the panel's boundary within this
  double congruence_tolerance = 1e-4;  // m, pieces (and halves) this alike are kept alike; 0: each piece goes its own way
  double alike_limit = 15e-3;          // m, but not those whose adjusted corners are further than this from their mean
  double chord_tolerance = 0.1e-3;     // m, a curve's points are set so close that its chords stay this near
};

struct Redrawn {
  Pattern pattern;           // same pieces, edges, notches, seams as the original; new geometry
  double max_deviation = 0;  // m, panel boundary to redrawn outline, each panel laid on it as well as it goes
  double symmetry = 0;       // m, worst departure of identical or mirrored pieces from each other
  double seam_mismatch = 0;  // m, worst departure of mating edges from their intended length ratio
  Report report;
};

// `garment` is the mesh of `original`; `rest` are its adjusted rest shapes. Guarantees:
//  1. Edges keep their ends, order, names and seams; straight edges stay straight, and in line where they were in line.
//  2. Copies of a piece, congruent pieces and the halves of a symmetric piece come out alike to rounding.
//  3. The two sides of a seam keep the ratio of lengths they have in `original`, also where only part of an edge is sewn.
//  4. Grain lines keep their direction: a piece is laid so that its panels' mean rotation is zero. Notches keep their fraction
//  of
//     their edge; lines and holes inside a piece go where its cloth goes.
//  5. A locked edge comes out congruent to how it was drawn.
//  6. An unchanged rest shape, wherever its panels lie and however they are turned, gives the original back.
// Throws std::invalid_argument when garment and pattern do not belong together.
Redrawn redraw(const Pattern& original, const GarmentMesh& garment, const RestShape& rest, const RedrawOptions& options = {});

// The rest shape of `garment`'s panels when cut from `pattern` (same pieces and edges as the pattern it was meshed from):
// boundary vertices on the new outline, at their fraction of it moved on as far as the boundary of `like` is stretched unevenly
// (the same on both sides of a seam, so that what is sewn together still lies at the same fraction); interior as rigid as
// possible to `like`. Throws BadInput("redraw.folded-panel") naming the panel when its triangles cannot be laid into the
// outline.
RestShape rest_on_outlines(const Pattern& pattern, const GarmentMesh& garment, const RestShape& like);

// m, worst departure of a seam's two lengths from the ratio they have in `original`.
double seam_mismatch(const Pattern& original, const Pattern& redrawn);

}  // namespace toile
