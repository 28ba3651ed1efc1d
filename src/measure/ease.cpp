#include "measure/ease.h"

#include <cmath>
#include <limits>

namespace toile {

Eigen::VectorXd air_to_body(const Eigen::Matrix3Xd& positions, const Body& body) {
  Eigen::VectorXd air(positions.cols());
  int guess = -1;
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const Eigen::Vector3d at = positions.col(v);
    const double seen = body.distance.distance(at);
    if (std::abs(seen) < body.distance.band()) {
      air(v) = seen;
      continue;
    }
    const NearestPoint nearest = body.skin.nearest(at, std::numeric_limits<double>::infinity(), guess);
    guess = nearest.triangle;
    air(v) = std::copysign(nearest.distance, seen);
  }
  return air;
}

}  // namespace toile
