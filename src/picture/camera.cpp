#include "picture/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace toile {

Camera::Camera(const View& view, const Eigen::Matrix3Xd& frame) : width_(view.width), height_(view.height) {
  const Eigen::Vector3d back = view.towards_viewer.normalized();
  const Eigen::Vector3d right = view.up.cross(back);
  if (!(right.norm() > 1e-6 * view.up.norm()) || frame.cols() == 0 || !frame.allFinite())
    throw std::invalid_argument("render: no picture from this view");
  axes_.row(0) = right.normalized();
  axes_.row(1) = back.cross(right.normalized());
  axes_.row(2) = back;
  Eigen::Matrix3Xd seen = axes_ * frame;
  const Eigen::Vector3d low = seen.rowwise().minCoeff();
  const Eigen::Vector3d high = seen.rowwise().maxCoeff();
  centre_ = axes_.transpose() * ((low + high) / 2);
  const double free = 1 - 2 * view.margin;
  const double least = 1e-9 + 1e-6 * (high - low).norm();
  const Eigen::Vector3d half = ((high - low) / 2).cwiseMax(least);
  if (view.angle <= 0) {
    scale_ = free * std::min(width_ / (2 * half.x()), height_ / (2 * half.y()));
    return;
  }
  scale_ = height_ / 2 / std::tan(view.angle / 2);
  seen.colwise() -= (low + high) / 2;
  distance_ = half.z() + least;
  for (Eigen::Index i = 0; i < seen.cols(); ++i) {
    const double wide = std::abs(seen(0, i)) * 2 * scale_ / (free * width_);
    const double tall = std::abs(seen(1, i)) * 2 * scale_ / (free * height_);
    distance_ = std::max(distance_, seen(2, i) + std::max(wide, tall));
  }
}

Eigen::Vector3d Camera::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d p = axes_ * (point - centre_);
  if (distance_ == 0) return {width_ / 2 + scale_ * p.x(), height_ / 2 - scale_ * p.y(), p.z()};
  const double far = distance_ - p.z();
  if (far < 0.02 * distance_) return Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  return {width_ / 2 + scale_ * p.x() / far, height_ / 2 - scale_ * p.y() / far, 1 / far};
}

Eigen::Vector3d Camera::to_viewer(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d back = axes_.row(2);
  return distance_ == 0 ? back : Eigen::Vector3d((centre_ + distance_ * back - point).normalized());
}

}  // namespace toile
