#pragma once
// From the scene to the picture.

#include <Eigen/Core>

#include "picture/render.h"

namespace toile {

class Camera {
 public:
  // Centres `frame` and moves back until all of it is in the picture.
  Camera(const View& view, const Eigen::Matrix3Xd& frame);

  // Pixel x, y (from the top left corner) and, third, the inverse of the distance along the line of sight (orthographic: minus
  // that distance), which is linear across the picture and grows towards the viewer. Not ahead of the camera: third is NaN.
  Eigen::Vector3d project(const Eigen::Vector3d& point) const;

  // Unit direction from `point` to the viewer.
  Eigen::Vector3d to_viewer(const Eigen::Vector3d& point) const;
  const Eigen::Matrix3d& axes() const { return axes_; }  // rows: right, up, towards the viewer

 private:
  Eigen::Matrix3d axes_;
  Eigen::Vector3d centre_;
  double distance_ = 0;  // from the viewer to the centre; 0: orthographic
  double scale_ = 1;     // pixels per unit at distance 1 (orthographic: per unit)
  double width_, height_;
};

}  // namespace toile
