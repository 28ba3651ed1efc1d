#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "draft/outline_fit.h"
#include "draft/shape_model.h"

namespace toile {
namespace {

constexpr std::array candidates{2, 3, 5, 9, 17};  // control points: 1, 2, 4, 8, 16 spans

struct Bend {
  double t;
  Eigen::Vector2d by;
};

// Samples of one edge from end to end, in the frame of the shape.
std::vector<Bend> edge_samples(const PanelOutline& panel, int edge, const Lay& lay) {
  std::vector<Bend> samples;
  for (const PanelOutline::Sample& sample : panel.samples) {
    if (sample.edge == edge) samples.push_back({sample.at, lay.to_shape(sample.point)});
    // The corner that ends an edge is the start of the next one.
    if (sample.at == 0 && sample.edge == (edge + 1) % panel.edges) samples.push_back({1, lay.to_shape(sample.point)});
  }
  std::sort(samples.begin(), samples.end(), [](const Bend& a, const Bend& b) { return a.t < b.t; });
  return samples;
}

Eigen::Vector2d between(const std::vector<Bend>& samples, double t) {
  const auto after = std::find_if(samples.begin() + 1, samples.end() - 1, [&](const Bend& b) { return b.t >= t; });
  const Bend &a = *(after - 1), &b = *after;
  return b.t > a.t ? Eigen::Vector2d(a.by + (t - a.t) / (b.t - a.t) * (b.by - a.by)) : a.by;
}

// How the samples of one panel bend run `i` of its piece, on top of the similarity of the chord between its own ends.
std::vector<Bend> bends_of(const PanelOutline& panel, const Run::Part& part, const Lay& lay, const Run& run) {
  const std::vector<Bend> samples = edge_samples(panel, part.edge, lay);
  if (samples.size() < 2) return {};
  Eigen::Vector2d a = between(samples, part.edge_begin), b = between(samples, part.edge_end);
  if (lay.reversed) std::swap(a, b);
  std::vector<Bend> bends;
  for (const Bend& sample : samples) {
    const double u = (sample.t - part.edge_begin) / (part.edge_end - part.edge_begin);
    if (u < 0 || u > 1) continue;
    const double t = lay.reversed ? 1 - u : u;
    bends.push_back({t, sample.by - a - on_chord(shape_at(run, t), b - a)});
  }
  return bends;
}

// Values at the samples of the least-squares bend with `controls` control points.
Eigen::MatrixX2d fitted(const std::vector<Bend>& bends, int controls) {
  Eigen::MatrixXd basis(static_cast<Eigen::Index>(bends.size()), controls);
  Eigen::MatrixX2d values(basis.rows(), 2);
  for (Eigen::Index i = 0; i < basis.rows(); ++i) {
    const Bend& bend = bends[static_cast<std::size_t>(i)];
    const std::vector<double> row = bend_basis(controls, bend.t);
    basis.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), controls);
    values.row(i) = bend.by.transpose();
  }
  Eigen::MatrixXd normal = basis.transpose() * basis;
  normal.diagonal().array() += 1e-9 * static_cast<double>(bends.size());
  return basis * normal.ldlt().solve(basis.transpose() * values);
}

}  // namespace

std::vector<int> bend_counts(const SharedShape& shape, const std::vector<Lay>& lays, const std::vector<Sides>& sides,
                             const std::vector<PanelOutline>& panels, double tolerance) {
  const int count = static_cast<int>(shape.sides.runs.size());
  std::vector<int> counts(static_cast<std::size_t>(count), 0);
  for (int r = 0; r < count; ++r) {
    const Run& run = shape.sides.runs[static_cast<std::size_t>(r)];
    if (run.straight) continue;
    std::vector<Bend> bends;
    std::size_t densest = 0;
    for (const PanelOutline& panel : panels) {
      const auto p = static_cast<std::size_t>(panel.piece);
      if (std::find(shape.pieces.begin(), shape.pieces.end(), panel.piece) == shape.pieces.end()) continue;
      for (int i = 0; i < count; ++i) {
        if (run_of(lays[p], i, count) != r) continue;
        const std::vector<Bend> more = bends_of(panel, sides[p].runs[static_cast<std::size_t>(i)].parts.front(), lays[p], run);
        densest = std::max(densest, more.size());
        bends.insert(bends.end(), more.begin(), more.end());
      }
    }
    // With fewer samples than two a control point the bend would follow the noise of the mesh.
    const int most = static_cast<int>(densest) / 2;
    int largest = 0;
    for (const int n : candidates)
      if (n <= std::max(most, 2) && bends.size() >= 3) largest = n;
    if (largest == 0) continue;
    const Eigen::MatrixX2d best = fitted(bends, largest);
    int& needed = counts[static_cast<std::size_t>(r)];
    if (best.rowwise().norm().maxCoeff() > tolerance / 2) {
      needed = largest;
      for (const int n : candidates) {
        if (n >= largest) break;
        if ((fitted(bends, n) - best).rowwise().norm().maxCoeff() > tolerance / 2) continue;
        needed = n;
        break;
      }
    }
  }
  for (int r = 0; shape.mirror && r < count; ++r) {
    const int twin = (((*shape.mirror - r) % count) + count) % count;
    int& mine = counts[static_cast<std::size_t>(r)];
    int& other = counts[static_cast<std::size_t>(twin)];
    mine = other = std::max(mine, other);
  }
  return counts;
}

}  // namespace toile
