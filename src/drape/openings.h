#pragma once
// Which limbs of the wearer go through which openings of the sewn garment, and whether that can be right.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "body/body.h"
#include "garment/mesh.h"
#include "garment/report.h"

namespace toile {

// "head", "hand.L", "hand.R", "foot.L", "foot.R", each from the pelvis outwards along the bones and beyond the body; of a
// body without limbs "head" and "feet", from the middle of its trunk up and down.
struct LimbChain {
  std::string name;
  std::vector<Eigen::Vector3d> points;
  std::vector<std::vector<Eigen::Vector3d>> other_ways;  // out of the body, for cloth that closes over `points`: under a hood
                                                         // forwards from the middle of the head, out of a wide sleeve down,
                                                         // over a wide skirt sideways or up
};
std::vector<LimbChain> limb_chains(const Mannequin& form);

struct Opening {
  std::vector<int> loop;            // garment vertices
  std::string name;                 // "opening along 'left_sleeve_f', 'left_sleeve_b'"
  double length = 0;                // m, at rest
  std::vector<std::string> limbs;   // that go through it
  std::vector<std::string> pieces;  // panels along it
  bool wound = false;               // some limb goes through it more than once
};

// Every chain takes the way out that passes through less cloth. An opening that is both above and below the body's middle, such
// as the edge of a coat that is open in front, holds what sets it apart from head and feet: the hands.
std::vector<Opening> openings(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Mannequin& form);

// Errors "drape.not-around-body" when no opening holds anything, else "drape.linked-wrong", naming the opening: nobody's limb
// goes through it; the head or a hand share it with a foot; it is sewn to a sleeve and holds no hand of that side. `sleeve_of`:
// by panel, "hand.L", "hand.R" or nothing.
Report check_openings(const std::vector<Opening>& openings, const GarmentMesh& garment,
                      const std::vector<std::string>& sleeve_of);

// Errors "drape.linked-wrong", naming the limb, when no way out of the body that it has is free of cloth: it is caught in the
// garment.
Report check_caught(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Mannequin& form);

}  // namespace toile
