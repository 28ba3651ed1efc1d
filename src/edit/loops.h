#pragma once
// The names a user may give a loop of the garment, and the closed vertex loops they mean.

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "edit/level_loops.h"
#include "edit/operation.h"
#include "edit/skeleton_chains.h"

namespace toile {

struct NamedLoops {
  std::vector<VertexLoop> loops;
  std::optional<Eigen::Hyperplane<double, 3>> level;  // when the name means a level: its plane, normal up or out along the bone
};

// The closed loops that `name` means, one or several (both legs' hems), none sharing a vertex with itself:
// - "hem": the edges with that id round trunk or legs; failing that, the lowest free boundary round trunk or legs;
// - "waist": the edges with that id; failing that, the highest free boundary round the trunk within 12 cm of the waist;
//   failing that, the landmark;
// - "armhole", "armhole.L", "neckline": the edges with that id; failing that, where sleeves or a collar are sewn on, or would
// be
//   (worn_loops.h);
// - "side", "gore.hem", "gore:3.hem", "front.e2,back.e0": edges of the pattern that close through their seams; edges with the
//   name of a landmark that do not close mean the landmark;
// - "hip": a landmark of the body: the loop of mesh edges nearest to that height, round trunk or legs; where the garment ends
//   before it, its free edge within 5 cm;
// - "spine_low:0.4": that share of a bone: level there for upright bones, across the bone for others.
// `place` is for messages ("edit 'length', loop"); `side` is of the plane of a level. Throws BadInput: edit.unknown-loop
// listing the names there are, edit.open-chain, edit.no-loop-there when the garment has no closed loop at a level that exists.
NamedLoops resolve_loops(const EditInput& input, const std::string& name, const std::string& place,
                         LevelSide side = LevelSide::nearer);

std::vector<std::string> split_names(const std::string& list);  // at commas, without blanks round them

double loop_length(const Eigen::Matrix3Xd& positions, const VertexLoop& loop);           // m
Eigen::Vector3d loop_centre(const Eigen::Matrix3Xd& positions, const VertexLoop& loop);  // weighted by length

}  // namespace toile
