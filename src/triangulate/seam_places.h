#pragma once
// Seams with names looked up: which run of which edge of which copy is sewn to which.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/pattern.h"
#include "garment/report.h"

namespace toile {

struct SpanPlace {
  int piece = 0;  // index into Pattern::pieces
  int copy = 1;
  int edge = 0;  // index into Piece::outline
  double begin = 0, end = 1;
};

struct SeamPlace {
  SpanPlace a, b;
};

// One per seam of the pattern. Ends on one edge that lie within 0.5 mm of each other or of the edge's end are made to agree.
// Throws BadInput: "seam.unknown-piece", "seam.unknown-edge", "seam.unknown-copy", "seam.span-outside-edge",
// "seam.span-too-short", "seam.overlap".
std::vector<SeamPlace> seam_places(const Pattern& pattern);

// "seam 'side' (gore:1 right to gore:2 left)"
std::string seam_in_words(const Seam& seam);

// The finding as an exception.
[[noreturn]] void refuse_seam(const char* code, const Seam& seam, std::string text, std::string remedy);

}  // namespace toile
