#pragma once
// Seam allowances and the cut sheet.

#include "garment/cut_sheet.h"
#include "garment/report.h"

namespace toile {

enum class Corner { mitre, mirrored, bevel };

struct AllowanceRules {
  double allowance = 10e-3;           // m, edges without their own
  double hem = 30e-3;                 // m, free edges named "hem" (or so marked) without their own
  double mitre_limit = 2.5;           // of the larger allowance; longer tips are bevelled
  std::vector<std::string> hem_edges = {"hem"};  // edge ids that are hems; their corners are mirrored
};

// The piece with its cut line. Throws BadInput("cut.allowance-crosses") naming the piece when the offset crosses itself beyond repair.
CutPiece add_allowance(const Piece& piece, const AllowanceRules& rules = {});

struct SheetRules {
  double width = 1.5;    // m, of the paper or cloth
  double gap = 10e-3;    // m, between pieces
  AllowanceRules allowances;
};

// All pieces once (a piece cut eight times is drawn once and says so), placed with their grain along the page's length.
CutSheet lay_out(const Pattern& pattern, const SheetRules& rules = {});

}  // namespace toile
