#include "formats/obj/hanging.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace toile {
namespace {

constexpr double faces_one_way = .6;  // length of the mean of its normals
constexpr double clear = 50e-3;       // m

std::optional<Placement> placement(const PanelMesh& panel, const Eigen::VectorXi& welded, const Eigen::Matrix3Xd& positions) {
  Eigen::Matrix3Xd hung(3, panel.rest.cols());
  for (Eigen::Index v = 0; v < panel.rest.cols(); ++v) hung.col(v) = positions.col(welded(v));
  Eigen::Vector3d normals = Eigen::Vector3d::Zero();
  double area = 0;
  for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
    const Eigen::Vector3d a = hung.col(panel.triangles(0, t)), b = hung.col(panel.triangles(1, t)),
                          c = hung.col(panel.triangles(2, t));
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    normals += normal;
    area += normal.norm();
  }
  if (!(area > 0) || normals.norm() < faces_one_way * area) return std::nullopt;

  const Eigen::Vector3d centre = hung.rowwise().mean();
  const Eigen::Vector2d middle = panel.rest.rowwise().mean();
  // Rest x and y and the outside, each as it hangs.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  covariance.leftCols<2>() = (hung.colwise() - centre) * (panel.rest.colwise() - middle).transpose();
  covariance.col(2) = normals.normalized() * covariance.norm();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
  if (turn.determinant() < 0) turn = svd.matrixU() * Eigen::Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
  const Eigen::Vector3d outside = turn.col(2);
  const double out = (outside.transpose() * (hung.colwise() - centre)).maxCoeff() + clear;
  return Placement{turn, centre + out * outside - turn.leftCols<2>() * middle};
}

}  // namespace

void place_by_drape(Pattern& pattern, const DrapedGarment& draped) {
  for (std::size_t p = 0; p < draped.garment.panels.size(); ++p) {
    const PanelMesh& panel = draped.garment.panels[p];
    Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    piece.placement.resize(static_cast<std::size_t>(copies(piece)));
    // A mirrored copy is drawn reflected before it is placed.
    piece.placement[static_cast<std::size_t>(panel.copy - 1)] = placement(panel, draped.garment.welded[p], draped.positions);
  }
}

}  // namespace toile
