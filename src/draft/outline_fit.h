#pragma once
// Outlines of all pieces fitted at once to the boundaries of their panels, seams trued.

#include <Eigen/Core>
#include <vector>

#include "draft/alike.h"
#include "draft/redraw.h"
#include "garment/pattern.h"

namespace toile {

// What one panel says about the outline of its piece: points on it, in the piece's frame.
struct PanelOutline {
  struct Sample {
    int edge = 0;
    double at = 0;  // fraction of the edge
    Eigen::Vector2d point;
    double weight = 0;  // m of outline it stands for
  };
  int piece = 0;
  int edges = 0;  // of the piece
  std::vector<Sample> samples;
};

struct FittedOutlines {
  std::vector<std::vector<Edge>> outlines;  // by piece; edges with the points they had, and more where a curve needs them
  int iterations = 0;
  bool converged = false;  // seams true to 1e-9 m
};

// Least squares over corners and bends, exact in the seams' ratios of lengths (Gauss-Newton on the constrained problem). Pieces
// no panel speaks for keep their outline.
FittedOutlines fit_outlines(const Pattern& original, const Likeness& likeness, const std::vector<PanelOutline>& panels,
                            const RedrawOptions& options);

// Control points each curve of a shape needs beyond the similarity of its chord, by run of the shape: the fewest that come
// within half the tolerance of what many would do.
std::vector<int> bend_counts(const SharedShape& shape, const std::vector<Lay>& lays, const std::vector<Sides>& sides,
                             const std::vector<PanelOutline>& panels, double tolerance);

// Shapes whose pieces (or halves) have come apart by more than options.alike_limit are taken apart, with a warning.
Likeness still_alike(const Pattern& original, Likeness likeness, const std::vector<PanelOutline>& panels,
                     const RedrawOptions& options, Report& report);

}  // namespace toile
