#include "triangulate/sizing.h"

#include <algorithm>

namespace toile {
namespace {

constexpr double growth = .3;       // of the size, per length away from a short side
constexpr double short_side = .85;  // of the edge length

}  // namespace

Sizing::Sizing(std::vector<Eigen::Vector2d> loop, double edge_length) : loop_(std::move(loop)), edge_length_(edge_length) {
  const std::size_t n = loop_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double spacing = ((loop_[i] - loop_[(i + n - 1) % n]).norm() + (loop_[(i + 1) % n] - loop_[i]).norm()) / 2;
    if (spacing < short_side * edge_length_) fine_.push_back({loop_[i], spacing});
  }
}

double Sizing::size(const Eigen::Vector2d& place) const {
  double size = edge_length_;
  for (const Fine& fine : fine_) size = std::min(size, fine.spacing + growth * (place - fine.at).norm());
  return size;
}

bool Sizing::inside(const Eigen::Vector2d& place, double margin) const {
  bool inside = false;
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    const Eigen::Vector2d& a = loop_[i];
    const Eigen::Vector2d& b = loop_[(i + 1) % loop_.size()];
    const Eigen::Vector2d d = b - a;
    const double t = std::clamp((place - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
    if ((a + t * d - place).squaredNorm() < margin * margin) return false;
    if ((a.y() > place.y()) != (b.y() > place.y()) && place.x() < a.x() + (place.y() - a.y()) / d.y() * d.x()) inside = !inside;
  }
  return inside;
}

}  // namespace toile
