#pragma once
// The body the garment is draped on. Metres, Y up, floor y = 0, faces +Z, wearer's left = +X.

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace toile {

struct Bone {
  std::string name;
  std::string parent;  // empty: the root
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  bool operator==(const Bone&) const = default;
};

struct Mannequin {
  std::string name;
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3Xi triangles;  // closed, oriented outwards
  std::vector<Bone> bones;
  std::map<std::string, double> landmarks;  // heights above the floor, m: "waist", "high_hip", "hip", "crotch", "bust", "nape", ...
  std::map<std::string, double> measures;   // girths and lengths, m: "waist", "hip", "bust", "thigh", ...
  double height = 0;
  bool operator==(const Mannequin&) const = default;
};

const Bone* find_bone(const Mannequin&, const std::string& name);

// One row of a size chart (templates/mannequins/): what a parametric mannequin is made from. Metres; a measure that is absent
// follows from the others as MANNEQUIN's proportions say.
struct SizeChartRow {
  std::string chart;  // "women", "men"
  std::string size;   // "38"
  bool female = true;
  double height = 1.68, bust = .88, waist = .70, hip = .94;
  std::map<std::string, double> others;  // "underbust", "high_hip", "neck", "upper_arm", "thigh", ...
  bool operator==(const SizeChartRow&) const = default;
};

}  // namespace toile
