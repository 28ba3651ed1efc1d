#include "style/normal_deviation.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace toile {

NormalDeviation normal_deviation(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& source,
                                 const Eigen::Matrix3Xd& target) {
  NormalDeviation deviation;
  double area = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const SourceTriangle& triangle = triangles[t];
    bool moved = false;
    for (int corner = 0; corner < 3; ++corner)
      moved = moved || (target.col(triangle.corners(corner)) - source.col(triangle.corners(corner))).squaredNorm() > 1e-18;
    if (!moved) continue;
    const Eigen::Matrix<double, 3, 2> map = map_of(triangle, target);
    const Eigen::Vector3d now = map.col(0).cross(map.col(1));
    const Eigen::Vector3d then = triangle.plane.col(0).cross(triangle.plane.col(1));
    const double angle = std::atan2(then.cross(now).norm(), then.dot(now));
    if (!(then.dot(now) > 0)) deviation.flipped.push_back(static_cast<int>(t));
    deviation.mean += angle * triangle.area;
    deviation.most = std::max(deviation.most, angle);
    area += triangle.area;
    const double sum = map.squaredNorm();
    const double product = now.norm();
    const double larger = std::sqrt(std::max(0.0, (sum + std::sqrt(std::max(0.0, sum * sum - 4 * product * product))) / 2));
    deviation.most_stretch = std::max(deviation.most_stretch, larger);
    if (larger > 0) deviation.least_stretch = std::min(deviation.least_stretch, product / larger);
  }
  if (area > 0) deviation.mean /= area;
  return deviation;
}

}  // namespace toile
