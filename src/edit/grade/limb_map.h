#pragma once
// Where the bones of one body are on another: the axial part of the relative parameterisation (p_b).

#include <utility>
#include <vector>

#include "body/relative.h"

namespace toile {

struct MappedBone {
  Eigen::Vector3d on_axis = Eigen::Vector3d::Zero();   // p_b on the other body
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();    // unit, along the limb there
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();  // from the limb's pose here to its pose there
};

// Trunks by the heights of the landmarks that both bodies have, in proportion between them; arms and legs in proportion from
// joint to joint.
class LimbMap {
 public:
  // Throws BadInput("edit.other-skeleton") when `to` lacks a limb of `from`.
  LimbMap(const Mannequin& from, const Mannequin& to);

  int limb(int from) const { return limb_[static_cast<std::size_t>(from)]; }
  MappedBone at(const RelativePlace& place) const;
  double height(double from) const;  // m above the floor
  double largest_turn() const;       // radians, of the limbs' poses

 private:
  double along(const LimbAxis& from, const LimbAxis& to, double at) const;

  std::vector<LimbAxis> from_, to_;
  std::vector<int> limb_;                           // by limb of `from`
  std::vector<std::pair<double, double>> heights_;  // ascending
};

}  // namespace toile
