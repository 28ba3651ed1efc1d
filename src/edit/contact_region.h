#pragma once
// Where a drape lies on the body.

#include <Eigen/Core>
#include <vector>

#include "edit/operation.h"
#include "edit/skeleton_chains.h"

namespace toile {

struct ContactRegion {
  Eigen::VectorXd gap;      // m, signed distance of every vertex to the body
  std::vector<bool> tight;  // nearer than 0.6 % of the body's height
  std::vector<bool>
      bearing;  // tight where the skin leans upwards, so that the garment hangs on it; all tight ones when none are
};

ContactRegion contact_region(const EditInput& input);

// Share of the loop's length whose vertices are tight.
double tight_share(const ContactRegion& region, const Eigen::Matrix3Xd& positions, const VertexLoop& loop);

}  // namespace toile
