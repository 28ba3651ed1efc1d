#include "edit/length/panel_chart.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <utility>

namespace toile {

PanelChart::Found PanelChart::find(const Eigen::Vector2d& rest) const {
  Found best{-1, -std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
  for (Eigen::Index t = 0; t < panel_.triangles.cols(); ++t) {
    const Eigen::Vector3i corner = panel_.triangles.col(t);
    const Eigen::Vector2d a = panel_.rest.col(corner(0));
    const Eigen::Vector2d u = Eigen::Vector2d(panel_.rest.col(corner(1))) - a;
    const Eigen::Vector2d w = Eigen::Vector2d(panel_.rest.col(corner(2))) - a;
    const Eigen::Vector2d d = rest - a;
    const double area = u.x() * w.y() - u.y() * w.x();
    const double second = (d.x() * w.y() - d.y() * w.x()) / area;
    const double third = (u.x() * d.y() - u.y() * d.x()) / area;
    const double inside = std::min({1 - second - third, second, third});
    if (inside <= best.inside) continue;
    best = {static_cast<int>(t), inside, {1 - second - third, second, third}};
    if (inside >= 0) break;
  }
  return best;
}

Eigen::Vector3d PanelChart::at(const Eigen::Vector2d& rest) const {
  const Found found = find(rest);
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) place += found.weights(i) * draped_.col(panel_.triangles(i, found.triangle));
  return place;
}

bool PanelChart::contains(const Eigen::Vector2d& rest) const { return find(rest).inside >= -1e-9; }

CarriedOn::CarriedOn(const PanelMesh& panel, const PanelChart& chart, std::vector<int> edge, Eigen::Matrix2Xd direction,
                     double behind)
    : panel_(panel), chart_(chart), edge_(std::move(edge)), direction_(std::move(direction)), behind_(behind) {}

Eigen::Vector2d CarriedOn::point(const Place& place) const {
  return (1 - place.share) * panel_.rest.col(edge_[place.first]) + place.share * panel_.rest.col(edge_[place.first + 1]);
}

Eigen::Vector2d CarriedOn::direction(const Place& place) const {
  const auto i = static_cast<Eigen::Index>(place.first);
  return ((1 - place.share) * direction_.col(i) + place.share * direction_.col(i + 1)).normalized();
}

CarriedOn::Place CarriedOn::nearest(const Eigen::Vector2d& rest) const {
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < edge_.size(); ++i) {
    const Eigen::Vector2d a = panel_.rest.col(edge_[i]);
    const Eigen::Vector2d along = Eigen::Vector2d(panel_.rest.col(edge_[i + 1])) - a;
    const double share = std::clamp((rest - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const double distance = (a + share * along - rest).norm();
    if (distance < least) {
      least = distance;
      best = {i, share};
    }
  }
  return best;
}

Eigen::Vector3d CarriedOn::at(const Eigen::Vector2d& rest) const {
  // The point of the edge whose cloth goes on to `rest`: the directions turn slowly along the edge.
  Place from = nearest(rest);
  double beyond = (rest - point(from)).dot(direction(from));
  for (int round = 0; round < 8; ++round) {
    from = nearest(rest - beyond * direction(from));
    beyond = (rest - point(from)).dot(direction(from));
  }
  const Eigen::Vector3d edge = chart_.at(point(from));
  const Eigen::Vector3d on = edge - chart_.at(point(from) - behind_ * direction(from));
  return edge + beyond * on.normalized();
}

}  // namespace toile
