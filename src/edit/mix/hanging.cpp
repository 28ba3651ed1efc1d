#include "edit/mix/hanging.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace toile {

HangingPanel::HangingPanel(const PanelMesh& panel, const Eigen::VectorXi& welded, const Eigen::Matrix3Xd& positions)
    : panel_(panel), welded_(welded), positions_(positions), low_(panel.rest.rowwise().minCoeff()) {
  const Eigen::Vector2d size = panel.rest.rowwise().maxCoeff() - low_;
  cell_ = 2 * std::sqrt(std::max(1e-9, size.x() * size.y()) / std::max<double>(1, static_cast<double>(panel.triangles.cols())));
  across_ = std::max(1, static_cast<int>(std::ceil(size.x() / cell_)));
  up_ = std::max(1, static_cast<int>(std::ceil(size.y() / cell_)));
  cells_.resize(static_cast<std::size_t>(across_) * static_cast<std::size_t>(up_));
  for (int t = 0; t < static_cast<int>(panel.triangles.cols()); ++t) {
    Eigen::Matrix<double, 2, 3> corners;
    for (int k = 0; k < 3; ++k) corners.col(k) = panel.rest.col(panel.triangles(k, t)) - low_;
    const Eigen::Vector2d low = corners.rowwise().minCoeff() / cell_, high = corners.rowwise().maxCoeff() / cell_;
    for (int y = std::clamp(static_cast<int>(low.y()), 0, up_ - 1); y <= std::clamp(static_cast<int>(high.y()), 0, up_ - 1);
         ++y)
      for (int x = std::clamp(static_cast<int>(low.x()), 0, across_ - 1);
           x <= std::clamp(static_cast<int>(high.x()), 0, across_ - 1); ++x)
        cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(x)].push_back(t);
  }
}

Eigen::Vector3d HangingPanel::at(const Eigen::Vector2d& rest) const {
  double best = -std::numeric_limits<double>::infinity();
  int triangle = 0;
  Eigen::Vector3d weights = Eigen::Vector3d::UnitX();
  const auto look = [&](int t) {
    const Eigen::Vector2d a = panel_.rest.col(panel_.triangles(0, t));
    Eigen::Matrix2d edges;
    edges << panel_.rest.col(panel_.triangles(1, t)) - a, panel_.rest.col(panel_.triangles(2, t)) - a;
    const Eigen::Vector2d b = edges.inverse() * (rest - a);
    const Eigen::Vector3d w(1 - b.x() - b.y(), b.x(), b.y());
    // How far outside, in metres: shares mean more in a large triangle.
    const double inside = std::min(0.0, w.minCoeff()) * std::sqrt(std::abs(edges.determinant()));
    if (inside > best) {
      best = inside;
      triangle = t;
      weights = w;
    }
  };
  const Eigen::Vector2d place = (rest - low_) / cell_;
  const int x = static_cast<int>(std::floor(place.x())), y = static_cast<int>(std::floor(place.y()));
  for (int reach = 1; best < 0 && reach <= std::max(across_, up_) + 1; reach = reach == 1 ? 2 : 2 * reach) {
    for (int v = std::max(0, y - reach); v <= std::min(up_ - 1, y + reach); ++v)
      for (int u = std::max(0, x - reach); u <= std::min(across_ - 1, x + reach); ++u)
        for (const int t :
             cells_[static_cast<std::size_t>(v) * static_cast<std::size_t>(across_) + static_cast<std::size_t>(u)])
          look(t);
    if (best > -0.5 * cell_ && reach > 1) break;
  }
  if (!(best > -std::numeric_limits<double>::infinity()))
    for (int t = 0; t < static_cast<int>(panel_.triangles.cols()); ++t) look(t);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) sum += weights(k) * positions_.col(welded_(panel_.triangles(k, triangle)));
  return sum;
}

}  // namespace toile
