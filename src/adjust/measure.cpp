#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "adjust/adjust.h"
#include "adjust/welded_seams.h"
#include "geometry/surface_distance.h"
#include "geometry/triangle_shape.h"

namespace toile {
namespace {

// m, how far all but the stiffest tenth of the garment has come down: what hangs from a seam that still holds moves less.
double rigid_drop(const Eigen::Matrix3Xd& target, const Eigen::Matrix3Xd& drape) {
  std::vector<double> drops;
  for (Eigen::Index v = 0; v < target.cols(); ++v) drops.push_back(target(1, v) - drape(1, v));
  if (drops.empty()) return 0;
  const auto tenth = drops.begin() + static_cast<std::ptrdiff_t>(drops.size() / 10);
  std::nth_element(drops.begin(), tenth, drops.end());
  return std::max(0.0, *tenth);
}

}  // namespace

AdjustStep measure(const Target& target, const RestShape& rest, const Drape& drape) {
  if (drape.positions.cols() != target.positions.cols() || target.positions.cols() != target.garment.vertex_count)
    throw std::invalid_argument("measure: drape, target and garment must have the same vertices");
  AdjustStep step;
  const Eigen::Matrix3Xi& triangles = target.garment.triangles;
  step.worst_stretch = 1;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const auto shape = [&](const Eigen::Matrix3Xd& at, int first) {
      return triangle_shape(Eigen::Vector3d(at.col(triangles(first, t))), at.col(triangles((first + 1) % 3, t)),
                            at.col(triangles((first + 2) % 3, t)));
    };
    const Eigen::Matrix2d draped = shape(drape.positions, 0), goal = shape(target.positions, 0);
    const Eigen::Vector2d values = stretch_values(draped, goal);
    const double agreement =
        values.allFinite() ? stretch_agreement(draped, goal) : 0;  // a triangle without area agrees with none
    step.stretch += agreement;
    for (int first = 0; first < 3 && values.allFinite(); ++first)
      step.printed_stretch += printed_agreement(shape(drape.positions, first), shape(target.positions, first)) / 3;
    step.worst_stretch = std::min(step.worst_stretch, agreement);
    step.contracting += values(0) <= 1 + 1e-12;
  }
  if (triangles.cols() > 0) {
    step.stretch /= static_cast<double>(triangles.cols());
    step.printed_stretch /= static_cast<double>(triangles.cols());
    step.contracting /= static_cast<double>(triangles.cols());
  }
  const SurfaceDistance distance = surface_distance({drape.positions, triangles}, {target.positions, triangles});
  step.mean = distance.mean;
  step.hausdorff = distance.hausdorff;
  step.seam_mismatch = seam_mismatch(target.garment, rest);
  step.residual = drape.residual;
  step.slipped = std::max(drape.slipped, rigid_drop(target.positions, drape.positions));
  step.seconds = drape.seconds;
  return step;
}

}  // namespace toile
