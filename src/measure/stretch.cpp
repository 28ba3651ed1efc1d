#include "measure/stretch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <numbers>
#include <stdexcept>

namespace toile {

GrainStretch grain_stretch(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions) {
  if (positions.cols() != garment.vertex_count) throw std::invalid_argument("grain_stretch: one position per garment vertex");
  const Eigen::Index count = triangle_count(garment);
  GrainStretch stretch{Eigen::VectorXd(count), Eigen::VectorXd(count), Eigen::VectorXd(count)};
  const std::vector<Eigen::Matrix2d> rest = rest_triangles(garment);
  Eigen::Index t = 0;
  for (const PanelMesh& panel : garment.panels) {
    Eigen::Matrix2d grain;  // columns: warp, weft
    grain << panel.warp.x(), -panel.warp.y(), panel.warp.y(), panel.warp.x();
    for (Eigen::Index i = 0; i < panel.triangles.cols(); ++i, ++t) {
      const Eigen::Vector3i corners = garment.triangles.col(t);
      Eigen::Matrix<double, 3, 2> edges;
      edges << positions.col(corners(1)) - positions.col(corners(0)), positions.col(corners(2)) - positions.col(corners(0));
      const Eigen::Matrix<double, 3, 2> f = edges * rest[static_cast<std::size_t>(t)].inverse() * grain;
      const double half = std::numbers::sqrt2 / 2;
      stretch.warp(t) = f.col(0).norm() - 1;
      stretch.weft(t) = f.col(1).norm() - 1;
      stretch.bias(t) = half * std::max((f.col(0) + f.col(1)).norm(), (f.col(0) - f.col(1)).norm()) - 1;
    }
  }
  return stretch;
}

}  // namespace toile
