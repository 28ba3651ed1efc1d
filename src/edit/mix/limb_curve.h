#pragma once
// A closed line round a limb as its height along the limb by angle: what a loop of one garment is on another (p_b and p_m of
// the relative parameterisation, paper Sec. 5).

#include <Eigen/Core>
#include <vector>

#include "body/relative.h"
#include "edit/operation.h"
#include "edit/skeleton_chains.h"

namespace toile {

// limb_axes, the first of them always the trunk's: where bones have other names than limb_axes knows, the upright line through
// the waist in place of the first bone.
std::vector<LimbAxis> trunk_and_limbs(const Mannequin& form);

struct LimbPlace {
  double along = 0;  // m from the start of the axis, negative before it
  double angle = 0;  // radians round it, 0 = front, 90 degrees = the wearer's left, in (-pi, pi]
};

LimbPlace limb_place(const Body& body, const LimbAxis& axis, int limb, const Eigen::Vector3d& at);

// Index into trunk_and_limbs of what a closed line is round: the trunk for lines round it or round both legs, an arm, a leg.
int limb_inside(const Body& body, const std::vector<LimbAxis>& axes, const std::vector<Eigen::Vector3d>& line);

struct LimbCurve {
  int limb = 0;
  std::vector<double> along;  // m, at the angles 2 pi i / size
};

// Of the closed line through `line`; where it is at several heights at one angle, their mean by length.
LimbCurve limb_curve(const Body& body, const std::vector<LimbAxis>& axes, const std::vector<Eigen::Vector3d>& line);
double along_at(const LimbCurve& curve, double angle);

// `curve` without what changes more often than `waves` times on the way round.
LimbCurve smoothed(const LimbCurve& curve, int waves);

// How far each vertex is beyond the curve, m along the limb.
Eigen::VectorXd beyond(const Body& body, const std::vector<LimbAxis>& axes, const LimbCurve& curve,
                       const Eigen::Matrix3Xd& positions);

}  // namespace toile
