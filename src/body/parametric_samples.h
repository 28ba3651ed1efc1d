#pragma once
// Four bodies, measured on the CC0 MakeHuman base mesh after it was fitted to chart girths: women 34, 38, 48 and men 50. What a
// chart does not say of a body is interpolated between them.

#include <array>
#include <functional>

namespace toile {

// Horizontal section of the trunk as measured, cm. The girth is the tape's.
struct TrunkSample {
  double girth, depth_to_width, centre, front, back, front_exponent, back_exponent;
};

struct BodySample {
  double height, bust, hip;  // cm
  TrunkSample hip_section, seat, high_hip, waist, underbust, bust_section, armpit;
  double shoulder_x, cage_half_width;
  std::array<double, 7> arm;  // girths at upper_arm_root, upper_arm, above_elbow, elbow, forearm, low_forearm, wrist
  std::array<double, 8> leg;  // thigh, mid_thigh, above_knee, knee, below_knee, calf, low_calf, ankle
};

inline constexpr std::array arm_names = {"upper_arm_root", "upper_arm",   "above_elbow", "elbow",
                                         "forearm",        "low_forearm", "wrist"};
inline constexpr std::array leg_names = {"thigh", "mid_thigh", "above_knee", "knee", "below_knee", "calf", "low_calf", "ankle"};

const BodySample& reference_woman();  // 38

// A figure of the samples at the place `at` of a ratio (girth to stature) that `key` gives of each sample: linear between them
// and up to .7 of an interval beyond. Men start from the one man and take over a share of the women's change.
double interpolated(bool female, double at, const std::function<double(const BodySample&)>& key,
                    const std::function<double(const BodySample&)>& value);

}  // namespace toile
