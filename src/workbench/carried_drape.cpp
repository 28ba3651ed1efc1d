#include "workbench/carried_drape.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "garment/report.h"

namespace toile {
namespace {

// The triangles of a panel's rest shape by the squares of a grid that they touch.
class FlatGrid {
 public:
  explicit FlatGrid(const PanelMesh& panel) : panel_(panel) {
    low_ = panel.rest.rowwise().minCoeff();
    const Eigen::Vector2d size = panel.rest.rowwise().maxCoeff() - low_;
    const double count = std::max<double>(1, static_cast<double>(panel.triangles.cols()));
    square_ = std::max(std::sqrt(size.x() * size.y() / count) * 2, size.maxCoeff() * 1e-3);
    for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
      Eigen::Vector2d from = corner(t, 0), to = from;
      for (int k = 1; k < 3; ++k) from = from.cwiseMin(corner(t, k)), to = to.cwiseMax(corner(t, k));
      const auto [i0, j0] = square_of(from);
      const auto [i1, j1] = square_of(to);
      for (int i = i0; i <= i1; ++i)
        for (int j = j0; j <= j1; ++j) squares_[{i, j}].push_back(t);
    }
  }

  // A triangle and weights of its corners (sum 1, none negative) for the point of the panel nearest to `at`.
  std::pair<Eigen::Index, Eigen::Vector3d> nearest(const Eigen::Vector2d& at) const {
    const auto [i, j] = square_of(at);
    std::pair<Eigen::Index, Eigen::Vector3d> best{-1, Eigen::Vector3d::Zero()};
    double distance = 1e300;
    const auto look_at = [&](Eigen::Index t) {
      const auto [weights, far] = on_triangle(t, at);
      if (far < distance) distance = far, best = {t, weights};
    };
    for (int ring = 0; ring < 3 && distance > 0; ++ring)
      for (int x = i - ring; x <= i + ring; ++x)
        for (int y = j - ring; y <= j + ring; ++y)
          if (std::max(std::abs(x - i), std::abs(y - j)) == ring)
            if (const auto found = squares_.find({x, y}); found != squares_.end())
              for (const Eigen::Index t : found->second) look_at(t);
    if (best.first < 0)
      for (Eigen::Index t = 0; t < panel_.triangles.cols(); ++t) look_at(t);
    return best;
  }

 private:
  Eigen::Vector2d corner(Eigen::Index t, int k) const { return panel_.rest.col(panel_.triangles(k, t)); }
  std::pair<int, int> square_of(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d at = (p - low_) / square_;
    return {static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
  }

  std::pair<Eigen::Vector3d, double> on_triangle(Eigen::Index t, const Eigen::Vector2d& at) const {
    const Eigen::Vector2d a = corner(t, 0);
    Eigen::Matrix2d sides;
    sides << corner(t, 1) - a, corner(t, 2) - a;
    if (sides.determinant() > 1e-14) {
      const Eigen::Vector2d w = sides.inverse() * (at - a);
      const Eigen::Vector3d weights(1 - w.sum(), w.x(), w.y());
      if (weights.minCoeff() >= -1e-9) return {weights, 0};
    }
    std::pair<Eigen::Vector3d, double> best{Eigen::Vector3d::UnitX(), 1e300};
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      const Eigen::Vector2d from = corner(t, k), along = corner(t, next) - from;
      const double length = along.squaredNorm();
      const double s = length > 0 ? std::clamp(along.dot(at - from) / length, 0.0, 1.0) : 0;
      const double far = (from + s * along - at).norm();
      if (far >= best.second) continue;
      Eigen::Vector3d weights = Eigen::Vector3d::Zero();
      weights[k] = 1 - s;
      weights[next] = s;
      best = {weights, far};
    }
    return best;
  }

  const PanelMesh& panel_;
  Eigen::Vector2d low_;
  double square_ = 1;
  std::map<std::pair<int, int>, std::vector<Eigen::Index>> squares_;
};

Eigen::Vector3d off_the_body(Eigen::Vector3d at, const Body& body, double offset) {
  for (int step = 0; step < 4; ++step) {
    const DistanceSample sample = body.distance.sample(at);
    const double slope = sample.gradient.norm();
    if (sample.distance >= offset || !(slope > 1e-6)) break;
    at += (offset - sample.distance) / slope * (sample.gradient / slope);
  }
  return at;
}

}  // namespace

Eigen::Matrix3Xd carried_drape(const DrapedGarment& draped, const GarmentMesh& garment, const Body& body, double offset) {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(garment.vertex_count);
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const auto source = std::find_if(draped.garment.panels.begin(), draped.garment.panels.end(), [&](const PanelMesh& other) {
      return other.piece == panel.piece && other.copy == panel.copy;
    });
    if (source == draped.garment.panels.end())
      throw BadInput({"drape.other-garment", Severity::error, "panel '" + panel.name + "'",
                      "the drape that came with the pattern has no such panel",
                      "Do not change the number of copies of a piece that comes draped"});
    const Eigen::VectorXi& welded = draped.garment.welded[static_cast<std::size_t>(source - draped.garment.panels.begin())];
    const FlatGrid flat(*source);
    for (Eigen::Index v = 0; v < panel.rest.cols(); ++v) {
      const auto [triangle, weights] = flat.nearest(panel.rest.col(v));
      const int to = garment.welded[p](v);
      for (int k = 0; k < 3; ++k) sum.col(to) += weights[k] * draped.positions.col(welded(source->triangles(k, triangle)));
      count[to] += 1;
    }
  }
  for (Eigen::Index v = 0; v < sum.cols(); ++v) sum.col(v) = off_the_body(sum.col(v) / std::max(count[v], 1.0), body, offset);
  return sum;
}

}  // namespace toile
