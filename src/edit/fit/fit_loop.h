#pragma once
// A loop whose points go away from the body or towards it, how far each may go, and what moves with it.

#include <string>
#include <utility>
#include <vector>

#include "body/relative.h"
#include "edit/contact_region.h"
#include "edit/operation.h"

namespace toile {

struct FitLoop {
  VertexLoop loop;
  Eigen::Vector3d axis = -Eigen::Vector3d::UnitY();  // unit, along the limb
  Eigen::Matrix3Xd outward;                          // by loop vertex, unit, from the bone
  Eigen::VectorXd share;                             // by loop vertex, of the offset: 1 in the range, 0 outside it
  Eigen::VectorXd room;                              // by loop vertex, m, how far it may go inwards
  std::vector<VertexLoop> anchor;                    // may be none
  std::vector<int> moving;                           // vertices that reach the loop without passing an anchor, ascending

  // m by loop vertex, along `outward`, when `by` is asked for (positive = away from the body) and the body stops it.
  Eigen::VectorXd offsets(double by) const;
  Eigen::Matrix3Xd moved(const Eigen::Matrix3Xd& positions, const Eigen::VectorXd& offsets) const;  // by loop vertex
};

struct FitRange {
  double from = 0, to = 0;  // radians round the limb, 0 = front, 90 degrees = the wearer's left; from < to
  bool whole() const;
};

// One for each loop that `loop` names. `anchor` names loops or levels that stay, separated by commas, or is "none", or "auto":
// on either side the nearest ring that lies on the body for at least half its length and is at least `release` (m) from the
// loop; for sleeves and trouser legs that have none the end of the limb. Towards the body a point has room to `least` (m by
// vertex) off the skin, or off the tape round both legs when they are both inside. Throws BadInput: edit.anchor-elsewhere when
// the loop cannot move for its anchor, edit.nothing-in-range, and what resolve_loops throws.
std::vector<FitLoop> fit_loops(const EditInput& input, const std::string& loop, const std::vector<RelativePlace>& places,
                               const ContactRegion& contact, const Eigen::VectorXd& least, const std::string& anchor,
                               double release, const FitRange& range);

// The loops that `names` means, levels on the side away from `loop`. Throws what resolve_loops throws.
std::vector<VertexLoop> anchors_named(const EditInput& input, const std::string& names, const VertexLoop& loop);

}  // namespace toile
