#pragma once
// What is printed or plotted and cut: pieces with both lines, placed on a page. Metres; page axes x right, y up, origin at the
// page's lower left corner.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "garment/pattern.h"

namespace toile {

struct CutNotch {
  Eigen::Vector2d at;         // on the cut line
  Eigen::Vector2d direction;  // unit, inwards
  Notch notch;
  bool operator==(const CutNotch&) const = default;
};

// A piece with its allowance, in the coordinates of the piece (not yet placed).
struct CutPiece {
  Piece piece;                                // the net piece; its outline is the sew line
  std::string size;
  std::vector<OutlinePoint> cut_line;         // closed loop without repeated point, counter-clockwise
  std::vector<CutNotch> notches;
  std::vector<std::string> labels;            // lines of text for the piece label
  bool operator==(const CutPiece&) const = default;
};

struct PlacedPiece {
  CutPiece cut;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  // piece to page: rotate by `turn`, then shift
  double turn = 0;                                  // radians
  bool operator==(const PlacedPiece&) const = default;
};

struct CutSheet {
  std::string title;
  double page_width = 0, page_length = 0;
  std::vector<PlacedPiece> placed;
  std::vector<std::string> notes;  // certificate lines printed on the sheet
  std::vector<Seam> seams;         // of the pattern, so that every sewn edge can be told what it is sewn to
  bool operator==(const CutSheet&) const = default;
};

}  // namespace toile
