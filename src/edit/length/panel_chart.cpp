#include "edit/length/panel_chart.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toile {

namespace {

constexpr double roundness = 0.5;  // share of the way to the tangent planes: exact on a circle
constexpr int evened_out = 8;      // rounds: what single triangles behind the edge say is no fold

}  // namespace

PanelChart::PanelChart(const PanelMesh& panel, const Eigen::Matrix3Xd& draped, const Eigen::Matrix3Xd& normals)
    : panel_(panel), draped_(draped), normals_(normals) {
  if (panel.triangles.cols() == 0) return;
  const Eigen::Vector2d least = panel.rest.rowwise().minCoeff(), most = panel.rest.rowwise().maxCoeff();
  const Eigen::Vector2d size = most - least;
  width_ = std::max({std::sqrt(size.prod() / static_cast<double>(panel.triangles.cols())), 1e-3 * size.maxCoeff(), 1e-9});
  corner_ = least - Eigen::Vector2d::Constant(0.01 * width_);
  columns_ = static_cast<int>(size.x() / width_ + 0.02) + 1;
  rows_ = static_cast<int>(size.y() / width_ + 0.02) + 1;
  touching_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
    const Eigen::Matrix<double, 2, 3> corners = panel.rest(Eigen::all, panel.triangles.col(t));
    const auto place = [&](const Eigen::Vector2d& at) -> Eigen::Array2i {
      return ((at - corner_) / width_).array().floor().cast<int>().max(0).min(Eigen::Array2i(columns_ - 1, rows_ - 1));
    };
    const Eigen::Vector2d slack = Eigen::Vector2d::Constant(1e-3 * width_);
    const Eigen::Array2i from = place(corners.rowwise().minCoeff() - slack), to = place(corners.rowwise().maxCoeff() + slack);
    for (int row = from.y(); row <= to.y(); ++row)
      for (int column = from.x(); column <= to.x(); ++column)
        touching_[static_cast<std::size_t>(row * columns_ + column)].push_back(static_cast<int>(t));
  }
}

int PanelChart::cell(const Eigen::Vector2d& rest) const {
  const Eigen::Vector2d at = (rest - corner_) / width_;
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() < columns_ && at.y() < rows_)) return -1;
  return static_cast<int>(at.y()) * columns_ + static_cast<int>(at.x());
}

bool PanelChart::takes(int triangle, const Eigen::Vector2d& rest, Found& best) const {
  const Eigen::Vector3i corner = panel_.triangles.col(triangle);
  const Eigen::Vector2d a = panel_.rest.col(corner(0));
  const Eigen::Vector2d u = Eigen::Vector2d(panel_.rest.col(corner(1))) - a;
  const Eigen::Vector2d w = Eigen::Vector2d(panel_.rest.col(corner(2))) - a;
  const Eigen::Vector2d d = rest - a;
  const double area = u.x() * w.y() - u.y() * w.x();
  const double second = (d.x() * w.y() - d.y() * w.x()) / area;
  const double third = (u.x() * d.y() - u.y() * d.x()) / area;
  const double inside = std::min({1 - second - third, second, third});
  if (inside <= best.inside) return false;
  best = {triangle, inside, {1 - second - third, second, third}};
  return true;
}

PanelChart::Found PanelChart::find(const Eigen::Vector2d& rest) const {
  const Found none{-1, -std::numeric_limits<double>::infinity(), Eigen::Vector3d::Zero()};
  Found best = none;
  if (const int here = cell(rest); here >= 0)
    for (const int t : touching_[static_cast<std::size_t>(here)])
      if (takes(t, rest, best) && best.inside >= 0) return best;
  best = none;
  for (Eigen::Index t = 0; t < panel_.triangles.cols(); ++t)
    if (takes(static_cast<int>(t), rest, best) && best.inside >= 0) break;
  return best;
}

Eigen::Vector3d PanelChart::at(const Eigen::Vector2d& rest) const {
  const Found found = find(rest);
  const Eigen::Vector3i corners = panel_.triangles.col(found.triangle);
  const Eigen::Vector3d flat = draped_(Eigen::all, corners) * found.weights;
  if (found.inside < 0) return flat;
  Eigen::Vector3d place = flat;
  for (int i = 0; i < 3; ++i)
    place -=
        roundness * found.weights(i) * normals_.col(corners(i)).dot(flat - draped_.col(corners(i))) * normals_.col(corners(i));
  return place;
}

bool PanelChart::contains(const Eigen::Vector2d& rest) const {
  const int here = cell(rest);
  if (here < 0) return false;
  Found best{-1, -1e-9, Eigen::Vector3d::Zero()};
  for (const int t : touching_[static_cast<std::size_t>(here)])
    if (takes(t, rest, best)) return true;
  return false;
}

CarriedOn::CarriedOn(const PanelMesh& panel, const PanelChart& chart, std::vector<int> edge, Eigen::Matrix2Xd direction,
                     double behind)
    : panel_(panel), chart_(chart), edge_(std::move(edge)), direction_(std::move(direction)), goes_on_(3, direction_.cols()) {
  for (Eigen::Index i = 0; i < direction_.cols(); ++i) {
    const Eigen::Vector2d at = panel_.rest.col(edge_[static_cast<std::size_t>(i)]);
    goes_on_.col(i) = (chart_.at(at) - chart_.at(at - behind * direction_.col(i).normalized())).normalized();
  }
  for (int round = 0; round < evened_out; ++round) {
    const Eigen::Matrix3Xd before = goes_on_;
    for (Eigen::Index i = 1; i + 1 < goes_on_.cols(); ++i)
      goes_on_.col(i) = (before.col(i - 1) + 2 * before.col(i) + before.col(i + 1)).normalized();
  }
}

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
  const auto i = static_cast<Eigen::Index>(from.first);
  const Eigen::Vector3d on = (1 - from.share) * goes_on_.col(i) + from.share * goes_on_.col(i + 1);
  return chart_.at(point(from)) + beyond * on.normalized();
}

}  // namespace toile
