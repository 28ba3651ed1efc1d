#pragma once
// A body of cylinders with a skeleton: radii and axes are known, so places relative to it have a closed form.

#include "body/tubes.h"
#include "garment/mannequin.h"

namespace toile::test {

constexpr double trunk_radius = .15, leg_radius = .07, arm_radius = .04, leg_x = .09;

inline Mannequin figure() {
  const Eigen::Vector3d shoulder(.16, 1.35, 0), wrist(.50, 1.01, 0);
  const Eigen::Vector3d mirror(-1, 1, 1);
  const auto right = [&](const Eigen::Vector3d& p) { return Eigen::Vector3d(p.cwiseProduct(mirror)); };
  Closed shape = cylinder({0, .78, 0}, {0, 1.45, 0}, trunk_radius);
  shape = both(shape, cylinder({0, 1.40, 0}, {0, 1.70, 0}, .06));
  for (const double side : {1., -1.}) shape = both(shape, cylinder({side * leg_x, 0, 0}, {side * leg_x, .83, 0}, leg_radius));
  shape = both(shape, cylinder(shoulder - Eigen::Vector3d(.05, -.05, 0), wrist, arm_radius));
  shape = both(shape, cylinder(right(shoulder - Eigen::Vector3d(.05, -.05, 0)), right(wrist), arm_radius));
  Mannequin form;
  form.name = "cylinders";
  form.positions = shape.positions;
  form.triangles = shape.triangles;
  form.height = 1.7;
  form.bones = {{"pelvis", "", {0, .85, 0}, {0, .86, .02}},           {"spine_low", "pelvis", {0, .86, 0}, {0, .98, 0}},
                {"spine_mid", "spine_low", {0, .98, 0}, {0, 1.1, 0}}, {"chest", "spine_mid", {0, 1.1, 0}, {0, 1.43, 0}},
                {"neck", "chest", {0, 1.43, 0}, {0, 1.5, 0}},         {"head", "neck", {0, 1.5, 0}, {0, 1.7, 0}}};
  for (const bool left : {true, false}) {
    const std::string end = left ? ".L" : ".R";
    const auto at = [&](const Eigen::Vector3d& p) { return left ? p : right(p); };
    const Eigen::Vector3d elbow = (shoulder + wrist) / 2;
    form.bones.push_back({"thigh" + end, "pelvis", at({leg_x, .82, 0}), at({leg_x, .45, 0})});
    form.bones.push_back({"shin" + end, "thigh" + end, at({leg_x, .45, 0}), at({leg_x, .05, 0})});
    form.bones.push_back({"upperarm" + end, "chest", at(shoulder), at(elbow)});
    form.bones.push_back({"forearm" + end, "upperarm" + end, at(elbow), at(wrist)});
  }
  form.landmarks = {{"waist", 1.05}, {"hip", .85}, {"crotch", .78}, {"armpit", 1.28}};
  return form;
}

}  // namespace toile::test
