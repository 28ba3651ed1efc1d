#pragma once
// Distance between two triangle surfaces, as Metro measures it (Cignoni et al. 1998): sampled both ways.

#include <Eigen/Core>

namespace toile {

struct Surface {
  const Eigen::Matrix3Xd& positions;
  const Eigen::Matrix3Xi& triangles;
};

struct SurfaceDistance {
  double hausdorff = 0;        // m, the larger of both one-sided maxima
  double mean = 0;             // m, the larger of both area-weighted one-sided means
  double a_to_b_max = 0;       // m, one-sided
  double b_to_a_max = 0;       // m
  Eigen::VectorXd a_vertices;  // m, distance of each vertex of `a` to surface `b`
};

// Samples at most `spacing` apart on every triangle (corners, edges and inside), nearest point by an AABB tree. The maxima are
// those of the samples: never above the true ones, and below them by less than spacing / sqrt(3). Throws std::invalid_argument
// when a surface has no area or positions that are not finite.
SurfaceDistance surface_distance(const Surface& a, const Surface& b, double spacing = 5e-3);

}  // namespace toile
