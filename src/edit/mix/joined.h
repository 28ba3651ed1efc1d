#pragma once
// Two parts of different garments sewn together.

#include <vector>

#include "edit/mix/take_part.h"
#include "edit/operation.h"

namespace toile {

// One of the garments that are mixed.
struct MixSide {
  const EditInput& input;
  Part part;
};

// A panel of the whole garment that one of the new pattern is part of.
struct PanelOrigin {
  int side = 0;  // 0: the edited garment, 1: the other
  int panel = 0;
};

struct JoinedPattern {
  Pattern pattern;
  std::vector<std::vector<PanelOrigin>> origin;  // [piece][copy - 1]
  int first_joint = 0;                           // index of the first seam that joins the sides; they are the last ones
  std::vector<bool> across;                      // by seam from there on: it is a cut across panels on both sides
};

// Sews ring i of one part to ring i of the other. Where seams of both come to the joint within 3 cm of each other they meet,
// between them the length is shared out evenly; otherwise both sides are matched by the angle round the limb. Throws BadInput
// edit.open-loop when a ring is not closed.
JoinedPattern join(const MixSide& first, const MixSide& second, const std::string& place);

struct JoinedGarment {
  GarmentMesh garment;
  std::vector<int> side;        // by panel
  Eigen::Matrix3Xd hanging[2];  // as the vertices of each side hang; NaN where it has none
  std::vector<int> joint;       // vertices of both sides, ascending
};

// Meshed with `edge_length` (m) and hung where its parts hung.
JoinedGarment hang(const JoinedPattern& joined, const MixSide& first, const MixSide& second, double edge_length);

}  // namespace toile
