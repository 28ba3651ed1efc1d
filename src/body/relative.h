#pragma once
// A garment point relative to the body: the nearest limb, the point of its axis (p_b) and the point of the skin (p_m).
// Paper Sec. 5, "Relative parameterization"; Brouet et al. 2012.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "body/body.h"

namespace toile {

// What garments are measured along: a polyline through the bones of one limb, running the way that part of a garment gets
// longer (down the trunk, out along arms and legs). "trunk": top of the head, neck, spine, the middle between the hip joints,
// then straight down to the floor, so that the hem of a skirt has one axis although two legs are nearer to it. "leg.L",
// "leg.R": hip joint, knee, ankle. "arm.L", "arm.R": shoulder joint, elbow, wrist, finger tips.
struct LimbAxis {
  std::string name;
  std::vector<Eigen::Vector3d> points;  // m, at least two
  double body_end = 0;                  // m along the axis, where the limb itself ends; only the trunk's axis goes on
  bool by_level = false;  // p_b is the axis at the height of the point and b points down, as levels are measured on a standing
                          // body; otherwise p_b is the nearest point of the axis
  bool operator==(const LimbAxis&) const = default;
};

// Trunk first. Bones are known by the names pelvis, spine_low, spine_mid, chest, neck, head, thigh, shin, upperarm, forearm,
// hand with .L and .R; the trunk needs thigh.L and thigh.R. A skeleton of other names gives one axis for each bone; a body
// without bones one trunk: the upright line through the middle of its waist.
std::vector<LimbAxis> limb_axes(const Mannequin& form);

struct RelativePlace {
  int limb = 0;                                        // index into limb_axes
  double along = 0;                                    // m from the start of the axis to p_b: the axial coordinate
  double beyond = 0;                                   // m, b . (v - p_b); not 0 only past an end of the axis
  Eigen::Vector3d on_axis = Eigen::Vector3d::Zero();   // p_b
  Eigen::Vector3d on_skin = Eigen::Vector3d::Zero();   // p_m, on the ray from p_b through v
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();    // b, unit, the way `along` grows
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();  // m, unit, from p_b to v
  double offset = 0;                                   // m, outward . (v - p_m); negative inside the skin
  bool through_skin = true;  // false: the ray meets no skin before v (a skirt between the legs); then p_m is the point of the
                             // skin nearest to v and `offset` the distance to it
};

// Of one point, by the limb with the least air between bone and point: length of segment p_b v outside the body (or depth of v
// inside it) + |b . (v - p_b)| + |v - p_b| / 4. The last term decides inside shoulders and hips, where there is no air.
RelativePlace relative_place(const Body& body, const Eigen::Vector3d& at);
// Of one point, by a limb that is already chosen.
RelativePlace relative_place(const Body& body, const LimbAxis& axis, int limb, const Eigen::Vector3d& at);

// Of every vertex of a garment, limbs chosen coherently: neighbours agree where their costs allow it, and below the armpits a
// ring of the garment takes what it surrounds: one arm (a sleeve), one leg (trousers), or the trunk, which is also the axis of
// a ring round both legs (a skirt) or round trunk and arms (a cape).
std::vector<RelativePlace> relative_places(const Body& body, const Eigen::Matrix3Xd& positions,
                                           const Eigen::Matrix3Xi& triangles);

}  // namespace toile
