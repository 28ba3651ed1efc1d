#pragma once
// Where the vertices of every outline go: alike on both sides of each seam, and alike on all copies of a piece.

#include <Eigen/Core>
#include <vector>

#include "garment/pattern.h"

namespace toile {

struct OutlineSample {
  int edge = 0;
  double at = 0;  // fraction of the edge's arc length, < 1
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
};

// By piece: the samples of its outline in order. The polygon through them is simple and counter-clockwise, and no two of its
// sides are joined by sewing except as mates. About `edge_length` (m) apart: the parts of edges between the ends of seams are
// divided evenly, sides of a seam into equally many parts (by the mean of their lengths, by the longer when it is gathered);
// finer where chords would shorten a curve by more than 0.1 % and 0.2 mm.
// Throws BadInput: "seam.ends-nearly-meet", "seam.not-manifold", "pattern.too-fine".
std::vector<std::vector<OutlineSample>> sample_outlines(const Pattern& pattern, double edge_length);

}  // namespace toile
