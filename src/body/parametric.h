#pragma once
// A mannequin from one row of a size chart: bust, waist, hip and the other girths of the row as a tape reads them.

#include "garment/mannequin.h"

namespace toile {

struct MannequinOptions {
  double edge_length = 14e-3;  // m, of the triangles, about; 4 to 18 mm, else std::invalid_argument
};

// Closed, one component, outwards, symmetric about x = 0, arms 45 degrees down; for one edge length, the same triangles in
// every size, so that vertex i of one size is vertex i of the other. Bones are named like those of a MakeHuman-derived skeleton
// (pelvis, spine_low, ..., upperarm.L, ...). Landmarks are the levels; measures are taped on the result (girth.h). Throws
// BadInput ("chart.implausible") when the row describes no body.
Mannequin build_mannequin(const SizeChartRow& row, const MannequinOptions& options = {});

}  // namespace toile
