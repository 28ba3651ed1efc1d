#pragma once
// Where the points of a panel hang.

#include <Eigen/Core>
#include <vector>

#include "garment/mesh.h"

namespace toile {

class HangingPanel {
 public:
  // Keeps references. `positions`: one column per garment vertex.
  HangingPanel(const PanelMesh& panel, const Eigen::VectorXi& welded, const Eigen::Matrix3Xd& positions);

  // Of a point in the panel's rest shape; beside it as the nearest triangle goes on.
  Eigen::Vector3d at(const Eigen::Vector2d& rest) const;

 private:
  const PanelMesh& panel_;
  const Eigen::VectorXi& welded_;
  const Eigen::Matrix3Xd& positions_;
  Eigen::Vector2d low_;
  double cell_ = 0;
  int across_ = 1, up_ = 1;
  std::vector<std::vector<int>> cells_;  // triangles by cell of a grid over the rest shape
};

}  // namespace toile
