#include "measure/tailoring.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

#include "garment/welds.h"
#include "geometry/topology.h"
#include "measure/cloth_section.h"

namespace toile {
namespace {

constexpr double spacing = 40e-3;  // m, of the heights
constexpr double clear = 10e-3;    // m, of a height from an opening

double cloth_round(const GarmentMesh& garment, const Eigen::Matrix3Xd& x, double height) {
  double length = 0;
  for (const ClothSection& section : cloth_sections(garment, x, {0, height, 0}, Eigen::Vector3d::UnitY()))
    for (const auto& piece : section.pieces) length += (piece[1] - piece[0]).norm();
  return length;
}

using Loops = std::vector<std::vector<int>>;

// Whether the height cuts an opening of this drape.
bool cuts(const Loops& loops, const Eigen::Matrix3Xd& x, double height) {
  for (const std::vector<int>& loop : loops) {
    double low = x(1, loop.front()), high = low;
    for (const int v : loop) {
      low = std::min(low, x(1, v));
      high = std::max(high, x(1, v));
    }
    if (height > low - clear && height < high + clear) return true;
  }
  return false;
}

double worst_girth(const GarmentMesh& garment, const Loops& loops, const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  double worst = 0;
  const double top = a.row(1).maxCoeff();
  for (double height = a.row(1).minCoeff() + spacing; height < top; height += spacing) {
    if (cuts(loops, a, height) || cuts(loops, b, height)) continue;
    const double before = cloth_round(garment, a, height);
    if (before > 0) worst = std::max(worst, std::abs(cloth_round(garment, b, height) / before - 1));
  }
  return worst;
}

double worst_seam(const GarmentMesh& garment, const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  std::map<std::pair<int, int>, double> difference;  // by panel and edge
  for (const BoundarySegment& segment : boundary_segments(garment)) {
    if (segment.mates.empty()) continue;
    const Eigen::VectorXi& welded = garment.welded[static_cast<std::size_t>(segment.panel)];
    const int from = welded(segment.from), to = welded(segment.to);
    difference[{segment.panel, segment.edge}] += (b.col(to) - b.col(from)).norm() - (a.col(to) - a.col(from)).norm();
  }
  double worst = 0;
  for (const auto& [edge, length] : difference) worst = std::max(worst, std::abs(length));
  return worst;
}

}  // namespace

TailoringDifference tailoring_difference(const GarmentMesh& garment, const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  if (a.cols() != garment.vertex_count || b.cols() != garment.vertex_count)
    throw std::invalid_argument("tailoring_difference: both drapes need one column per garment vertex");
  const Loops loops = boundary_loops(garment.triangles);
  TailoringDifference difference;
  difference.girth = worst_girth(garment, loops, a, b);
  difference.seam_length = worst_seam(garment, a, b);
  for (const std::vector<int>& loop : loops) {
    double moved = 0;
    for (const int v : loop) moved += b(1, v) - a(1, v);
    difference.level = std::max(difference.level, std::abs(moved / static_cast<double>(loop.size())));
  }
  return difference;
}

bool only_folds_differ(const TailoringDifference& difference) {
  return difference.girth <= 5e-3 && difference.seam_length <= 2e-3 && difference.level <= 3e-3;
}

}  // namespace toile
