#pragma once
// How far an edit turned the garment's normals, and whether it turned triangles over.

#include <Eigen/Core>
#include <vector>

#include "style/source_shape.h"

namespace toile {

struct NormalDeviation {
  double mean = 0;           // radians, area-weighted
  double most = 0;           // radians
  std::vector<int> flipped;  // indices into `triangles`, turned over or by more than a right angle
  double least_stretch = 1;  // smallest and largest singular value of the maps from source to target triangle
  double most_stretch = 1;
};

// Over the triangles with a corner that moved by more than 1e-9 m.
NormalDeviation normal_deviation(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& source,
                                 const Eigen::Matrix3Xd& target);

}  // namespace toile
