#pragma once
// The result of pattern adjustment (paper Sec. 4): rest shapes, and how the iteration got there.

#include <string>
#include <vector>

#include "garment/drape.h"
#include "garment/mesh.h"

namespace toile {

struct AdjustStep {
  double stretch = 0;               // mean of S, Eq. 8 with singular values
  double worst_stretch = 0;         // its smallest value
  double printed_stretch = 0;       // mean of S with eigenvalues, as Eq. 8 is printed; the mean of a triangle's three corners
  double mean = 0;                  // mean surface distance to the target, m
  double hausdorff = 0;             // symmetric surface distance to the target, m
  double seam_mismatch = 0;         // m, worst departure of a mating pair of edges from its intended length ratio
  double contracting = 0;           // share of triangles whose B_i contracts
  double embedding_distortion = 0;  // mean |sigma - 1| of the embedding
  double residual = 0;              // of the drape
  double slipped = 0;               // m
  double seconds = 0;
};

enum class AdjustStop { agreed, stalled, step_limit, slipped, not_developable };

struct Adjustment {
  RestShape rest;                 // the best found
  Drape drape;                    // its drape
  std::vector<AdjustStep> steps;  // steps[0] is the plain flattening, the baseline
  int best = 0;                   // index into steps
  AdjustStop stop = AdjustStop::step_limit;
  RestShape flattened;  // the plain flattening's rest shape
  Drape flattened_drape;
  double seconds = 0;
};

std::string in_words(AdjustStop);

}  // namespace toile
