#pragma once
// Seam allowances and the cut sheet.

#include <string>
#include <vector>

#include "garment/cut_sheet.h"
#include "garment/report.h"

namespace toile {

// mitre: both cut lines go on until they meet. mirrored: at a hem, the reflection of the neighbour's cut line about the hem
// line, so that the hem, turned up, ends on it. bevel: cut off square where the tip leaves the wider allowance.
enum class Corner { mitre, mirrored, bevel };

struct AllowanceRules {
  double allowance = 10e-3;                      // m, edges without their own; 0: a fold, the cut line is the net line
  double hem = 30e-3;                            // m, hems without their own
  double mitre_limit = 2.5;                      // of the wider allowance, at least 1; longer tips are bevelled there
  std::vector<std::string> hem_edges = {"hem"};  // ids of hems beside the edges marked as such
  Corner corner = Corner::mitre;                 // mitre or bevel
  Corner hem_corner = Corner::mirrored;
};

// The piece with its cut line, every edge moved outwards by its own allowance. Guarantees:
//  1. No cut line comes nearer to an edge than the smallest of its allowance and those of the two edges it meets (less 1e-6 m).
//  2. Edges with no allowance (folds) do not move, and the neighbour's allowance ends on their straight continuation.
//  3. The cut line is a simple counter-clockwise polygon without spikes.
//  4. Straight stays straight: a straight edge has no cut point between its corners; a curve has one for each of its points,
//  with
//     its flags. Every corner of the cut line is a turn point.
//  5. A hem with mirrored corners, turned up about its line, ends on the cut lines of its neighbours.
//  6. As many notches as before, each on the cut line square to its place on the sew line; they stay at least a fifth of the
//     allowance away from it. Where there is no allowance a notch lies on the edge with depth 0: a mark, not to be snipped.
// Where allowances overlap at a concave place (a tight curve, a dart) the cut line is the outline of their union: a dart is cut
// open only as far as its legs keep their allowances apart, and cut straight across its mouth where they do nowhere; its legs
// remain sew lines inside the piece. A leg may be several edges that hardly turn. Throws BadInput "cut.allowance-crosses"
// naming piece and edge when they close a gap of the outline or bury an edge that is not a dart's leg, "cut.outline-crosses"
// when the net outline crosses itself; std::invalid_argument for a clockwise or open outline, negative or non-finite
// allowances.
CutPiece add_allowance(const Piece& piece, const AllowanceRules& rules = {});

struct SheetRules {
  double width = 1.5;     // m, of the paper or cloth
  double gap = 10e-3;     // m, between pieces
  double margin = 10e-3;  // m, kept free along the page's edges
  bool one_way = false;   // nap or print: all pieces the same way up, none turned by 180 degrees
  AllowanceRules allowances;
};

// All pieces once (a piece cut eight times is drawn once and says so), placed with their grain along the page's length (y),
// bottom first, longest first; same input, same sheet. A piece without grain line gets one along its y axis. An edge that a
// seam joins is never a hem. Throws BadInput "cut.page-too-narrow" naming the piece, and what add_allowance throws.
CutSheet lay_out(const Pattern& pattern, const SheetRules& rules = {});

}  // namespace toile
