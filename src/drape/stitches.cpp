#include "drape/stitches.h"

#include <Eigen/Dense>
#include <algorithm>

namespace toile {
namespace {

Eigen::Vector3d middle_of(const std::vector<int>& group, const Eigen::Matrix3Xd& x) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int v : group) middle += x.col(v);
  return middle / static_cast<double>(group.size());
}

double smooth_step(double t) { return t * t * (3 - 2 * t); }

}  // namespace

Stitches::Stitches(const LoosePanels& cloth, int steps) : cloth_(cloth), steps_(steps) {
  if (!cloth.layer.empty()) layers_ = 1 + *std::max_element(cloth.layer.begin(), cloth.layer.end());
  start_.assign(static_cast<std::size_t>(cloth.positions.cols()), 0.0);
}

// What is to meet in the layer that is sewn now; beyond the last, everything.
void Stitches::gather() {
  stitches_.clear();
  for (const auto& group : cloth_.stitched) {
    Stitch stitch;
    for (const int v : group) {
      const int own = layers_ == 1 ? 0 : cloth_.layer[static_cast<std::size_t>(v)];
      if (own == layer_ || layer_ == layers_)
        stitch.drawn.push_back(v);
      else if (own < layer_)
        stitch.closed.push_back(v);
    }
    if (stitch.closed.size() + stitch.drawn.size() > 1) stitches_.push_back(std::move(stitch));
  }
}

void Stitches::begin(int step, const Eigen::Matrix3Xd& x) {
  if (const int layer = std::min(step / steps_, layers_); layer != layer_) {
    layer_ = layer;
    gather();
    for (const Stitch& stitch : stitches_)
      for (const int v : stitch.drawn)
        start_[static_cast<std::size_t>(v)] =
            (x.col(v) - middle_of(stitch.closed.empty() ? stitch.drawn : stitch.closed, x)).norm();
  }
  const int since = step - std::min(layer_, layers_ - 1) * steps_;
  share_ = std::min(1.0, static_cast<double>(since + 1) / steps_);
  open_ = 1 - smooth_step(share_);
}

void Stitches::pull(Eigen::Matrix3Xd& x) const {
  for (const Stitch& stitch : stitches_) {
    const Eigen::Vector3d middle = middle_of(stitch.closed.empty() ? stitch.drawn : stitch.closed, x);
    const auto draw = [&](int v, double allowed) {
      const Eigen::Vector3d apart = x.col(v) - middle;
      const double length = apart.norm();
      if (length > allowed) x.col(v) -= (1 - allowed / length) * apart;
    };
    for (const int v : stitch.closed) draw(v, 0);
    for (const int v : stitch.drawn) draw(v, open_ * start_[static_cast<std::size_t>(v)]);
  }
}

}  // namespace toile
