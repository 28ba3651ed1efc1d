#pragma once
// A garment carried over to another body point by point: the initial target of Brouet et al. 2012 (patent US 9177423, claim 2).

#include <vector>

#include "body/relative.h"
#include "edit/grade/limb_map.h"
#include "edit/operation.h"

namespace toile {

struct Transferred {
  Eigen::Matrix3Xd positions;         // x^0
  Eigen::Matrix3Xd axis;              // unit, along the limb on the other body
  Eigen::VectorXd level;              // m, axis coordinate that each vertex should have there
  std::vector<Eigen::Matrix3d> turn;  // of the limb's pose, evened out over the mesh
};

// Bodies with the same triangles: vertex i of one is vertex i of the other.
bool same_topology(const Mannequin& a, const Mannequin& b);

// Every vertex as far off the skin as it was (absolute ease), in the direction it had from its bone, at the place along the
// limb that its bone point maps to. Its point of the skin is the same point of the triangles where the bodies have the same
// topology and the cloth is near it (all of it up to 2 cm, none from 10 cm on), else where the ray from the bone meets the
// skin. Vertices whose ray meets none follow their neighbours.
Transferred transfer(const EditInput& input, const std::vector<RelativePlace>& places, const Body& to, const LimbMap& map);

}  // namespace toile
