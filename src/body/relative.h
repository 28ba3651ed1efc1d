#pragma once
// A garment point relative to the body: the nearest limb, the point of its axis (p_b) and the point of the skin (p_m).
// Paper Sec. 5, "Relative parameterization"; Brouet et al. 2012.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "body/body.h"

namespace toile {

// What garments are measured along: a polyline through the bones of one limb, running the way that part of a garment gets
// longer (down the trunk, out along arms and legs). "trunk": top of the head, base of the neck, hip centre (between the hip
// joints), then straight down to the floor, so that the hem of a skirt has one axis although two legs are nearer to it.
// "leg.L", "leg.R": hip joint, knee, ankle. "arm.L", "arm.R": shoulder joint, elbow, wrist, finger tips.
struct LimbAxis {
  std::string name;
  std::vector<Eigen::Vector3d> points;  // m, at least two
  std::vector<std::string> bones;       // of each segment; empty where none of the skeleton's bones is behind it
  bool operator==(const LimbAxis&) const = default;
};

// Trunk first. Needs the bones neck, thigh.L and thigh.R for the trunk (head, upperarm, forearm, hand, shin for the rest); a
// skeleton of other names gives one axis for each bone, a body without bones the upright line through the middle of its waist.
std::vector<LimbAxis> limb_axes(const Mannequin& form);

struct RelativePlace {
  int limb = 0;                                        // index into limb_axes
  int segment = 0;                                     // of that axis
  double fraction = 0;                                 // 0..1 along the segment
  double along = 0;                                    // m from the start of the axis, the axial coordinate
  double beyond = 0;                                   // m, b . (v - p_b): not 0 only past an end of the axis or at a bend
  Eigen::Vector3d on_axis = Eigen::Vector3d::Zero();   // p_b
  Eigen::Vector3d on_skin = Eigen::Vector3d::Zero();   // p_m
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();    // b, unit, the way `along` grows
  Eigen::Vector3d outward = Eigen::Vector3d::UnitZ();  // m, unit, from p_b through the point
  double offset = 0;                                   // m, outward . (v - p_m); negative inside the skin
  bool through_skin = true;  // false: the ray from p_b through the point meets no skin (a skirt between the legs); then p_m
                             // is the point of the skin nearest to v and `offset` the distance to it
};

// Of one point, by the cheapest limb: |v - p_m| + |b . (v - p_b)|.
RelativePlace relative_place(const Body& body, const Eigen::Vector3d& at);
// Of one point, by a limb that is already chosen.
RelativePlace relative_place(const Body& body, const std::vector<LimbAxis>& axes, int limb, const Eigen::Vector3d& at);

// Of every vertex of a garment, limbs chosen coherently: neighbours agree where their costs allow it, and a horizontal ring of
// the garment takes the limb it surrounds, below the armpits: one leg (trousers), one arm (a sleeve), or the trunk - as does a
// ring that surrounds both legs (a skirt).
std::vector<RelativePlace> relative_places(const Body& body, const Eigen::Matrix3Xd& positions,
                                           const Eigen::Matrix3Xi& triangles);

}  // namespace toile
