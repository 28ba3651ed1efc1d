#pragma once
// How two drapes of one garment differ for a tape measure: what stays when folds merely fall otherwise.

#include <Eigen/Core>

#include "garment/mesh.h"

namespace toile {

struct TailoringDifference {
  double girth = 0;        // share, worst over the heights: cloth round the figure, along its folds
  double seam_length = 0;  // m, worst of the seam lines as they hang
  double level = 0;        // m, worst of the openings' mean heights: hem, waist, cuffs
  bool operator==(const TailoringDifference&) const = default;
};

// Girths every 4 cm, but not where an opening is cut. `a` is what `b` is held against; one column per garment vertex, m. Throws
// std::invalid_argument for another number.
TailoringDifference tailoring_difference(const GarmentMesh& garment, const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b);

// The same to a pattern maker's eye: girth within .5 %, seams 2 mm, levels 3 mm.
bool only_folds_differ(const TailoringDifference& difference);

}  // namespace toile
