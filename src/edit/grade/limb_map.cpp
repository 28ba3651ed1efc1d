#include "edit/grade/limb_map.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "body/landmarks.h"

namespace toile {
namespace {

double length_of(const LimbAxis& axis) {
  double length = 0;
  for (std::size_t i = 1; i < axis.points.size(); ++i) length += (axis.points[i] - axis.points[i - 1]).norm();
  return length;
}

Eigen::Vector3d point_at(const LimbAxis& axis, double along) {
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const double length = (axis.points[i] - axis.points[i - 1]).norm();
    if (along <= length || i + 1 == axis.points.size())
      return axis.points[i - 1] + std::clamp(along / length, 0.0, 1.0) * (axis.points[i] - axis.points[i - 1]);
    along -= length;
  }
  return axis.points.front();
}

Eigen::Vector3d point_at_height(const LimbAxis& axis, double height) {
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const Eigen::Vector3d &a = axis.points[i - 1], &b = axis.points[i];
    if (height >= b.y() || i + 1 == axis.points.size())
      return a + std::clamp((a.y() - height) / (a.y() - b.y()), 0.0, 1.0) * (b - a);
  }
  return axis.points.front();
}

// Of the limb round `along`, evened out over a joint.
Eigen::Vector3d direction_at(const LimbAxis& axis, double along) {
  constexpr double either_side = 0.04;
  const double length = length_of(axis);
  const double middle = std::clamp(along, either_side, std::max(either_side, length - either_side));
  return (point_at(axis, middle + either_side) - point_at(axis, middle - either_side)).normalized();
}

// Landmarks of both, lowest first, without those that would stretch or squeeze what is between them against all sense.
std::vector<std::pair<double, double>> common_heights(const Mannequin& from, const Mannequin& to) {
  const UprightExtent a = upright_extent(from), b = upright_extent(to);
  const double scale = (b.high - b.low) / std::max(1e-6, a.high - a.low);
  std::vector<std::pair<double, double>> found;
  for (const char* name : {"ankle", "knee", "crotch", "hip", "waist", "bust", "nape"}) {
    const auto here = from.landmarks.find(name), there = to.landmarks.find(name);
    if (here != from.landmarks.end() && there != to.landmarks.end()) found.emplace_back(here->second, there->second);
  }
  found.emplace_back(a.high, b.high);
  std::sort(found.begin(), found.end());
  std::vector<std::pair<double, double>> kept{{a.low, b.low}};
  for (const auto& [here, there] : found) {
    const double apart = here - kept.back().first;
    const double ratio = (there - kept.back().second) / (scale * apart);
    if (apart > 0.03 && ratio > 0.6 && ratio < 1.6) kept.emplace_back(here, there);
  }
  if (kept.size() < 2) kept.emplace_back(a.high, b.high);
  return kept;
}

}  // namespace

LimbMap::LimbMap(const Mannequin& from, const Mannequin& to)
    : from_(limb_axes(from)), to_(limb_axes(to)), heights_(common_heights(from, to)) {
  for (const LimbAxis& axis : from_) {
    const auto there = std::find_if(to_.begin(), to_.end(), [&](const LimbAxis& other) {
      return other.name == axis.name && other.by_level == axis.by_level;
    });
    if (there == to_.end())
      throw BadInput({"edit.other-skeleton", Severity::error, "edit 'grade', body '" + to.name + "'",
                      "its skeleton has no '" + axis.name + "', which the garment's body '" + from.name + "' has",
                      "give it a skeleton with the same names of bones"});
    limb_.push_back(static_cast<int>(there - to_.begin()));
  }
}

double LimbMap::height(double from) const {
  std::size_t i = 1;
  while (i + 1 < heights_.size() && from > heights_[i].first) ++i;
  const auto& [a, a_there] = heights_[i - 1];
  const auto& [b, b_there] = heights_[i];
  return a_there + (from - a) / (b - a) * (b_there - a_there);
}

double LimbMap::along(const LimbAxis& from, const LimbAxis& to, double at) const {
  if (from.points.size() != to.points.size()) return at * length_of(to) / length_of(from);
  double there = 0;
  for (std::size_t i = 1; i < from.points.size(); ++i) {
    const double length = (from.points[i] - from.points[i - 1]).norm();
    const double length_there = (to.points[i] - to.points[i - 1]).norm();
    if (at <= length || i + 1 == from.points.size()) return there + at / length * length_there;
    at -= length;
    there += length_there;
  }
  return there;
}

MappedBone LimbMap::at(const RelativePlace& place) const {
  const LimbAxis& from = from_[static_cast<std::size_t>(place.limb)];
  const LimbAxis& to = to_[static_cast<std::size_t>(limb(place.limb))];
  MappedBone bone;
  if (from.by_level) {
    bone.on_axis = point_at_height(to, height(place.on_axis.y()));
    return bone;
  }
  const double there = along(from, to, place.along);
  bone.on_axis = point_at(to, there);
  bone.turn = Eigen::Quaterniond::FromTwoVectors(direction_at(from, place.along), direction_at(to, there)).toRotationMatrix();
  bone.axis = bone.turn * place.axis;
  return bone;
}

double LimbMap::largest_turn() const {
  double largest = 0;
  for (std::size_t i = 0; i < from_.size(); ++i) {
    const auto &here = from_[i].points, &there = to_[static_cast<std::size_t>(limb_[i])].points;
    const Eigen::Vector3d a = here.back() - here.front(), b = there.back() - there.front();
    largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return largest;
}

}  // namespace toile
