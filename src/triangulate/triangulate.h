#pragma once
// Pieces to triangles (constrained Delaunay with refinement, CGAL).

#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

struct TriangulateOptions {
  double edge_length = 15e-3;  // m, aimed for along outlines and inside
  double smallest_angle = 20;  // degrees; smaller ones are left only where the outline forces them
};

// One mesh per copy of every piece, copies of a piece alike. Guarantees:
//  1. Mating spans of a seam have the same number of vertices at the same fractions, also when their lengths differ.
//  2. Every turn point is a vertex; no vertex is added on the outline by the refinement.
//  3. Triangles are counter-clockwise and not degenerate.
// Throws BadInput naming the piece or the seam: "pattern.*" (triangulate/outline.h), "seam.*" (triangulate/seam_places.h,
// triangulate/sampling.h), "mesh.edge-length-too-short" beyond two million triangles.
std::vector<PanelMesh> triangulate(const Pattern& pattern, const TriangulateOptions& options = {});

// Welds the panels along the pattern's seams. Throws BadInput naming the seam: "seam.twisted" when it would join a right side
// to a wrong side without saying so, "seam.not-manifold"; std::invalid_argument when the panels are not of this pattern.
GarmentMesh sew(const Pattern& pattern, std::vector<PanelMesh> panels);

}  // namespace toile
