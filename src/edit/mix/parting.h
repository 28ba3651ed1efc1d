#pragma once
// What a garment falls into when it is parted along loops: panels on either side, and panels cut in two.

#include <optional>
#include <string>
#include <vector>

#include "body/relative.h"
#include "edit/mix/cut_line.h"
#include "edit/operation.h"

namespace toile {

struct OutlinePlace {
  int edge = 0;   // index into Piece::outline
  double at = 0;  // fraction of its arc length
};

// A cut across a panel, in the frame of its piece.
struct Chord {
  OutlinePlace from, to;
  std::vector<Eigen::Vector2d> points;  // m, both ends included
  bool beyond_left = false;             // which side of it, on the way from `from` to `to`, is beyond the loop
  int loop = 0, rank = 0;               // the loop it is part of, and its place on the way round
};

struct PanelParting {
  bool beyond = false;  // where it is, when it is not cut
  std::vector<Chord> chords;
};

struct Parting {
  std::vector<PanelParting> panels;  // by panel of the garment
  std::vector<CutLoop> loops;
};

// "Beyond" is the side of a loop on which the limb it is round goes on. Throws BadInput: edit.cut-inside-panel,
// edit.not-parted.
Parting part_garment(const EditInput& input, const std::vector<CutLoop>& loops, const std::string& place);

// Lines that run within `near` (m) of seams or free edges all the way round are moved there.
std::vector<CutLoop> moved_to_seams(const EditInput& input, const std::vector<CutLoop>& loops, double near,
                                    const std::string& place);

// The panel from whose one edge a line cuts off less than 4 cm^2, if there is one: the line touches a seam there.
std::optional<std::string> sliver(const EditInput& input, const CutLoop& loop, const std::string& place);

}  // namespace toile
