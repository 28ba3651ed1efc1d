#pragma once
// What a closed loop is round: which ends of the skeleton (head, hands, feet) pass through it.

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

#include "garment/mannequin.h"

namespace toile {

using VertexLoop = std::vector<int>;  // closed, the first vertex not repeated

enum class ChainEnd { head, hand, foot };

// The bones from the root to one end of the skeleton, prolonged outwards.
struct SkeletonChain {
  ChainEnd end = ChainEnd::foot;
  std::vector<Eigen::Vector3d> path;  // m
};

// One per end of the skeleton, in the order of the bones; ends are told apart by their height. A body without bones gets an
// upright axis through its middle: one head, one foot.
std::vector<SkeletonChain> skeleton_chains(const Mannequin& form);

// Times a segment passes through the fan of triangles between the loop and its centre, signed by side.
int crossings(const Eigen::Matrix3Xd& positions, const VertexLoop& loop, const Eigen::Vector3d& from,
              const Eigen::Vector3d& to);

struct Threading {
  std::set<int> chains;                             // indices of the chains that pass through
  Eigen::Vector3d along = Eigen::Vector3d::Zero();  // unit direction of the part of the first of them that does, outwards
  int heads = 0, hands = 0, feet = 0;
  bool nothing() const { return chains.empty(); }
  bool round_one_arm() const { return hands == 1 && heads == 0 && feet == 0; }
  bool round_trunk_or_leg() const { return heads > 0 || feet > 0; }
};

Threading threading(const std::vector<SkeletonChain>& chains, const Eigen::Matrix3Xd& positions, const VertexLoop& loop);

bool round_trunk(const Threading& ring);
// `ring` is round what `loop` is round, or round the trunk that its leg goes on into.
bool same_limb(const Threading& loop, const Threading& ring);

}  // namespace toile
