#pragma once
// Stitches that shorten step by step: those of one layer after those of the layers under it.

#include <Eigen/Core>
#include <vector>

#include "drape/sewing.h"

namespace toile {

class Stitches {
 public:
  // Every layer's stitches shorten over `steps` steps.
  Stitches(const LoosePanels& cloth, int steps);

  int layers() const { return layers_; }
  // Before each step, with the positions at its beginning.
  void begin(int step, const Eigen::Matrix3Xd& x);
  // Share of its steps that the layer sewn now has behind it when the step ends.
  double share() const { return share_; }
  bool outermost() const { return layer_ + 1 >= layers_; }
  // Brings every stitched vertex to within the open share of its starting distance from the stitch's middle; where layers
  // under it meet there already, they are the middle.
  void pull(Eigen::Matrix3Xd& x) const;

 private:
  struct Stitch {
    std::vector<int> closed, drawn;  // vertices of layers under the one that is sewn, and of that one
  };
  void gather();

  const LoosePanels& cloth_;
  int steps_, layers_ = 1, layer_ = -1;
  double share_ = 0, open_ = 1;
  std::vector<Stitch> stitches_;
  std::vector<double> start_;  // m, by vertex
};

}  // namespace toile
