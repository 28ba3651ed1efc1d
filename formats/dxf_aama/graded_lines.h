#pragma once
// The lines of a piece in the sample size, and where their vertices go in each other size.

#include <string>
#include <vector>

#include "formats/dxf_aama/drawn_piece.h"
#include "formats/rul/rul.h"
#include "garment/report.h"

namespace toile::aama {

// A line, or one point. `in_size[s]` has as many points as `points`, for each size s; closed lines repeat the first point.
struct GradedLine {
  Points<2> points;
  std::vector<Points<2>> in_size;
};

struct GradedLines {
  std::vector<GradedLine> lines;    // sew lines first
  std::vector<GradedLine> drills;   // one point each
  std::vector<GradedLine> notches;  // likewise, those that have moves of their own
  int mirror = -1;                  // which of `lines` is the mirror line
};

// From a nest: vertices by their numbers where a size is drawn as the sample size is, otherwise corner to corner and along the
// line between (note "aama.nest-along"). `sizes[s]` may be `sample` itself. Error-free: a line that a size lacks is left out
// and moves with the outline; a piece without any outline in a size keeps the sample size's (warning "aama.not-graded").
GradedLines nest_lines(const DrawnPiece& sample, const std::vector<const DrawnPiece*>& sizes,
                       const std::vector<std::string>& size_names, Report& report);

// By grade rules: points with a rule move by it, x along the grade reference line; between them moves are interpolated along
// the line. `unit` is metres per unit of the table. Warning "aama.rule-missing" for numbers the table has not.
GradedLines ruled_lines(const DrawnPiece& sample, const GradeTable& table, double unit, Report& report);

}  // namespace toile::aama
