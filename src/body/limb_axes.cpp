#include <Eigen/Geometry>
#include <algorithm>

#include "body/girth.h"
#include "body/landmarks.h"
#include "body/relative.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

double length(const std::vector<Vec>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

void add_point(std::vector<Vec>& points, const Vec& at) {
  if (points.empty() || (points.back() - at).norm() > 1e-6) points.push_back(at);
}

// The axis through the bones in `chain` that exist, from the first one's start to the last one's end.
void add_limb(const Mannequin& form, const std::string& name, const std::vector<std::string>& chain,
              std::vector<LimbAxis>& axes) {
  LimbAxis limb;
  limb.name = name;
  for (const std::string& part : chain)
    if (const Bone* bone = find_bone(form, part)) {
      add_point(limb.points, bone->from);
      add_point(limb.points, bone->to);
    }
  if (limb.points.size() < 2) return;
  limb.body_end = length(limb.points);
  axes.push_back(std::move(limb));
}

// From the top down, every point lower than the one before, so that each level has one point.
LimbAxis upright_axis(const std::vector<Vec>& downwards, double floor) {
  LimbAxis trunk;
  trunk.name = "trunk";
  trunk.by_level = true;
  for (const Vec& at : downwards)
    if (trunk.points.empty() || at[1] < trunk.points.back()[1] - 1e-3) trunk.points.push_back(at);
  trunk.body_end = length(trunk.points);
  if (const Vec& last = trunk.points.back(); last[1] > floor + 1e-3) trunk.points.push_back({last[0], floor, last[2]});
  return trunk;
}

Vec middle_of_waist(const Mannequin& form, double low, double high) {
  const double level = low + .62 * (high - low);
  Vec centre = form.positions.rowwise().mean();
  double longest = 0;
  for (const SectionLoop& loop : section_loops(form.positions, form.triangles, {0, level, 0}, Vec::UnitY()))
    if (const double girth = loop_girth(loop, Vec::UnitY(), GirthKind::tape); girth > longest) {
      longest = girth;
      Eigen::AlignedBox3d box;
      for (const Vec& at : loop) box.extend(at);
      centre = box.center();
    }
  return centre;
}

}  // namespace

std::vector<LimbAxis> limb_axes(const Mannequin& form) {
  const UprightExtent extent = upright_extent(form);
  const double floor = std::min(0.0, extent.low);
  std::vector<LimbAxis> axes;
  const Bone *left = find_bone(form, "thigh.L"), *right = find_bone(form, "thigh.R");
  if (left && right) {
    std::vector<Vec> downwards;
    for (const char* name : {"head", "neck", "chest", "spine_mid", "spine_low"})
      if (const Bone* bone = find_bone(form, name)) {
        downwards.push_back(bone->to);
        downwards.push_back(bone->from);
      }
    const Vec hips = (left->from + right->from) / 2;
    // The spine ends in the sacrum, behind the hip joints: only what is above them counts.
    downwards.erase(std::remove_if(downwards.begin(), downwards.end(),
                                   [&](const Vec& at) { return at[1] < hips[1] + .03 * (extent.high - extent.low); }),
                    downwards.end());
    if (downwards.empty()) downwards.push_back({hips[0], extent.high, hips[2]});
    downwards.push_back(hips);
    axes.push_back(upright_axis(downwards, floor));
    for (const std::string side : {".L", ".R"}) {
      add_limb(form, "leg" + side, {"thigh" + side, "shin" + side}, axes);
      add_limb(form, "arm" + side, {"upperarm" + side, "forearm" + side, "hand" + side}, axes);
    }
    return axes;
  }
  for (const Bone& bone : form.bones) add_limb(form, bone.name, {bone.name}, axes);
  if (!axes.empty()) return axes;
  const Vec waist = middle_of_waist(form, extent.low, extent.high);
  axes.push_back(upright_axis({{waist[0], extent.high, waist[2]}, {waist[0], extent.low, waist[2]}}, floor));
  return axes;
}

}  // namespace toile
