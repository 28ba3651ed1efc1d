#include "body/distance_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "body/grid_winding.h"
#include "body/spline_grid.h"
#include "body/triangle_tree.h"
#include "parallel/in_chunks.h"

namespace toile {
namespace {

constexpr int stride = 4;       // fine cells per coarse cell, each way
constexpr int blend_cells = 4;  // beyond the band, over which exact samples give way to coarse ones
constexpr std::size_t most_nodes = 400'000'000;

void require_closed(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  if (triangles.cols() == 0) throw std::invalid_argument("DistanceField: no triangles");
  if (triangles.minCoeff() < 0 || triangles.maxCoeff() >= positions.cols())
    throw std::invalid_argument("DistanceField: a triangle names a vertex that is not there");
  if (!positions.allFinite()) throw std::invalid_argument("DistanceField: positions are not finite");
  std::vector<std::pair<int, int>> there, back;
  double volume = 0;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      const int from = triangles(c, t), to = triangles((c + 1) % 3, t);
      there.emplace_back(from, to);
      back.emplace_back(to, from);
    }
    const Eigen::Vector3d a = positions.col(triangles(0, t)), b = positions.col(triangles(1, t)),
                          c = positions.col(triangles(2, t));
    volume += a.dot(b.cross(c)) / 6;
  }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  if (there != back) throw std::invalid_argument("DistanceField: the triangles are not closed or not oriented alike");
  if (!(volume > 0)) throw std::invalid_argument("DistanceField: the triangles are oriented inwards");
}

// The grid that holds the surface with `margin` around it; its sizes are whole numbers of coarse cells plus one.
GridFrame frame_around(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, double cell, double margin) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) box.extend(Eigen::Vector3d(positions.col(triangles(c, t))));
  GridFrame frame;
  frame.cell = cell;
  frame.origin = box.min().array() - margin;
  double nodes = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = std::ceil((box.sizes()[axis] + 2 * margin) / cell / stride) * stride;
    nodes *= cells + 1;
    if (!(nodes < static_cast<double>(most_nodes)))
      throw std::invalid_argument("DistanceField: cell " + std::to_string(cell) + " m is too fine for a surface of this size");
    frame.size[axis] = static_cast<int>(cells) + 1;
  }
  return frame;
}

// Signed distances at the nodes of `frame`: exact up to `band`, trilinear between exact ones at every `stride`-th node from
// `band` + blend on, and a mixture between.
class Sampler {
 public:
  Sampler(const GridFrame& frame, double band, const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
          int threads)
      : fine_(frame),
        coarse_(frame),
        band_(band),
        blend_(blend_cells * frame.cell),
        tree_(positions, triangles),
        winding_(winding_on_grid(frame, positions, triangles)),
        threads_(threads) {
    coarse_.cell = frame.cell * stride;
    coarse_.size = (frame.size.array() - 1) / stride + 1;
    sample_coarse();
  }

  std::vector<float> samples() const {
    std::vector<float> result(fine_.nodes());
    in_chunks(coarse_.size[2], threads_, [&](int k) {
      for (int j = 0; j < coarse_.size[1]; ++j)
        for (int i = 0; i < coarse_.size[0]; ++i) sample_block({i, j, k}, result);
    });
    return result;
  }

 private:
  double sign(int i, int j, int k) const { return winding_[fine_.index(i, j, k)] > 0 ? -1 : 1; }

  void sample_coarse() {
    signed_.resize(coarse_.nodes());
    in_chunks(coarse_.size[2], threads_, [&](int k) {
      for (int j = 0; j < coarse_.size[1]; ++j) {
        int guess = -1;
        for (int i = 0; i < coarse_.size[0]; ++i) {
          const NearestPoint found = tree_.nearest(coarse_.at(i, j, k), std::numeric_limits<double>::infinity(), guess);
          guess = found.triangle;
          signed_[coarse_.index(i, j, k)] = sign(i * stride, j * stride, k * stride) * found.distance;
        }
      }
    });
  }

  double trilinear(int i, int j, int k) const {
    double sum = 0;
    const Eigen::Vector3i node(i, j, k);
    const Eigen::Vector3i base = (node.array() / stride).min(coarse_.size.array() - 2);
    const Eigen::Vector3d t = (node - stride * base).cast<double>() / stride;
    for (int corner = 0; corner < 8; ++corner) {
      const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
      sum += (a ? t[0] : 1 - t[0]) * (b ? t[1] : 1 - t[1]) * (c ? t[2] : 1 - t[2]) *
             signed_[coarse_.index(base[0] + a, base[1] + b, base[2] + c)];
    }
    return sum;
  }

  // The fine nodes to which this coarse node is the nearest.
  void sample_block(const Eigen::Vector3i& coarse, std::vector<float>& result) const {
    const double here = signed_[coarse_.index(coarse[0], coarse[1], coarse[2])];
    const Eigen::Vector3i centre = stride * coarse;
    const Eigen::Vector3i low = (centre.array() - stride / 2).max(0),
                          high = (centre.array() + stride / 2).min(fine_.size.array());
    const double reach = std::sqrt(3.0) * stride / 2 * fine_.cell;
    std::optional<TriangleTree::Neighbourhood> near;
    if (std::abs(here) - reach <= band_ + blend_)
      near = tree_.around(coarse_.at(coarse[0], coarse[1], coarse[2]), std::abs(here), reach);
    for (int k = low[2]; k < high[2]; ++k)
      for (int j = low[1]; j < high[1]; ++j)
        for (int i = low[0]; i < high[0]; ++i) result[fine_.index(i, j, k)] = static_cast<float>(sample(i, j, k, near));
  }

  double sample(int i, int j, int k, const std::optional<TriangleTree::Neighbourhood>& near) const {
    if (!near) return trilinear(i, j, k);
    const double exact = sign(i, j, k) * near->distance(fine_.at(i, j, k));
    const double t = std::clamp((std::abs(exact) - band_) / blend_, 0.0, 1.0);
    const double coarse_share = t * t * (3 - 2 * t);
    return coarse_share > 0 ? (1 - coarse_share) * exact + coarse_share * trilinear(i, j, k) : exact;
  }

  GridFrame fine_, coarse_;
  double band_, blend_;
  TriangleTree tree_;
  std::vector<std::int16_t> winding_;
  std::vector<double> signed_;  // coarse nodes, m
  int threads_;
};

}  // namespace

struct DistanceField::Grid {
  SplineGrid spline;
  double band;

  // The place inside the grid that `at` is judged by: itself, or the nearest point of the box.
  Eigen::Vector3d inside(const Eigen::Vector3d& at) const {
    const GridFrame& frame = spline.frame();
    const Eigen::Array3d low = frame.origin.array() + 2 * frame.cell;
    const Eigen::Array3d high = frame.origin.array() + (frame.size.array() - 3).cast<double>() * frame.cell;
    return at.array().max(low).min(high);
  }
};

DistanceField::DistanceField(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles, double cell, double band) {
  if (!(cell > 0 && band > 0)) throw std::invalid_argument("DistanceField: cell and band must be positive");
  require_closed(positions, triangles);
  const GridFrame frame = frame_around(positions, triangles, cell, band + (blend_cells + 2) * cell);
  const int threads = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 8u));
  grid_ = std::make_shared<const Grid>(
      Grid{SplineGrid(frame, Sampler(frame, band, positions, triangles, threads).samples(), threads), band});
}

double DistanceField::distance(const Eigen::Vector3d& at) const {
  if (!grid_) throw std::invalid_argument("DistanceField::distance: the field is empty");
  const Eigen::Vector3d inside = grid_->inside(at);
  return grid_->spline.value(inside) + (at - inside).norm();
}

DistanceSample DistanceField::sample(const Eigen::Vector3d& at) const {
  if (!grid_) throw std::invalid_argument("DistanceField::sample: the field is empty");
  const Eigen::Vector3d inside = grid_->inside(at);
  SplineSample found = grid_->spline.sample(inside);
  DistanceSample result{found.value, found.gradient, found.hessian};
  const Eigen::Vector3d out = at - inside;
  const double beyond = out.norm();
  if (beyond == 0) return result;
  // Beyond the grid: the value at the nearest point of its box plus the way there; directions across that way keep the field's
  // own derivatives.
  const Eigen::Vector3d along = (out.array() == 0).cast<double>();
  const Eigen::Vector3d across = Eigen::Vector3d::Ones() - along;
  const Eigen::Vector3d direction = out / beyond;
  result.distance += beyond;
  result.gradient = along.cwiseProduct(found.gradient) + direction;
  result.hessian = along.asDiagonal() * found.hessian * along.asDiagonal();
  result.hessian += (Eigen::Matrix3d(across.asDiagonal()) - direction * direction.transpose()) / beyond;
  return result;
}

double DistanceField::band() const { return grid_ ? grid_->band : 0; }

}  // namespace toile
