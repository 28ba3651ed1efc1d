#pragma once
// The body's push on the cloth, step after step: asks the distance field only where cloth may have come near since it was last
// asked, and follows the field by its second derivatives over small moves.

#include <Eigen/Core>
#include <vector>

#include "drape/mass_spring/cloth.h"

namespace toile::mass_spring {

class BodyContact {
 public:
  explicit BodyContact(const Cloth& cloth);

  // Moves cloth that is deep inside the body towards its surface, then writes the push there to `push` and how much it grows
  // with depth, as a row sum, to `stiffness` (N/m by vertex). No vertex may have moved further than `longest_move` since the
  // last call.
  void update(double longest_move, Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& push, Eigen::VectorXd& stiffness);

 private:
  struct Near {
    int sample = 0;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    DistanceSample field;
  };
  void look_round(const Eigen::Matrix3Xd& x);

  const Cloth& cloth_;
  std::vector<double> far_until_;  // by sample: the travel up to which it cannot be near
  std::vector<Near> near_;
  double travel_ = 0;        // m, at least what any vertex has moved
  double looked_until_ = 0;  // travel at which near_ must be made anew
};

}  // namespace toile::mass_spring
