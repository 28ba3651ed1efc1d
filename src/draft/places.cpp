#include "draft/places.h"

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "garment/welds.h"

namespace toile {
namespace {

double length(const Eigen::Matrix2Xd& at, const BoundarySegment& segment) {
  return (at.col(segment.to) - at.col(segment.from)).norm();
}

// Own panel and edge, and those it is sewn to.
std::vector<std::pair<int, int>> sewing_of(const BoundarySegment& segment, const std::vector<BoundarySegment>& all) {
  std::vector<std::pair<int, int>> edges{{segment.panel, segment.edge}};
  for (const int mate : segment.mates)
    edges.emplace_back(all[static_cast<std::size_t>(mate)].panel, all[static_cast<std::size_t>(mate)].edge);
  return edges;
}

}  // namespace

std::vector<std::vector<double>> places_on_outline(const GarmentMesh& garment, const RestShape& like) {
  const std::vector<BoundarySegment> segments = boundary_segments(garment);
  const std::size_t count = segments.size();
  // A stretch: neighbouring segments of one edge sewn to the same edges. Shares of its length by segment.
  std::vector<std::vector<std::size_t>> stretches;
  for (std::size_t first = 0; first < count;) {
    std::size_t end = first;
    while (end < count && segments[end].panel == segments[first].panel) ++end;
    const std::size_t n = end - first;
    const auto starts = [&](std::size_t i) {
      const std::size_t before = first + (i - first + n - 1) % n;
      const double corner = segments[i].begin < segments[i].end ? 0.0 : 1.0;
      return segments[i].begin == corner || sewing_of(segments[i], segments) != sewing_of(segments[before], segments);
    };
    std::size_t start = first;
    while (start < end && !starts(start)) ++start;
    for (std::size_t k = 0; k < n && start < end; ++k) {
      const std::size_t i = first + (start - first + k) % n;
      if (starts(i)) stretches.emplace_back();
      stretches.back().push_back(i);
    }
    first = end;
  }
  std::vector<double> share(count, 0.0);
  for (const auto& stretch : stretches) {
    double sum = 0;
    for (const std::size_t i : stretch) {
      const auto p = static_cast<std::size_t>(segments[i].panel);
      share[i] = std::abs(segments[i].end - segments[i].begin) * length(like[p], segments[i]) /
                 length(garment.panels[p].rest, segments[i]);
      sum += share[i];
    }
    for (const std::size_t i : stretch) share[i] /= sum;
  }
  std::vector<double> shared = share;
  for (std::size_t i = 0; i < count; ++i) {
    for (const int mate : segments[i].mates) shared[i] += share[static_cast<std::size_t>(mate)];
    shared[i] /= 1.0 + static_cast<double>(segments[i].mates.size());
  }
  std::vector<double> begin(count), end(count);
  for (const auto& stretch : stretches) {
    double sum = 0, before = 0;
    for (const std::size_t i : stretch) sum += shared[i];
    const double from = segments[stretch.front()].begin, to = segments[stretch.back()].end;
    for (const std::size_t i : stretch) {
      begin[i] = from + (to - from) * before / sum;
      before += shared[i];
      end[i] = from + (to - from) * before / sum;
    }
  }
  std::vector<std::vector<double>> places;
  std::size_t first = 0;
  for (const PanelMesh& panel : garment.panels) {
    const std::size_t n = panel.boundary.size();
    places.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      const bool corner = panel.boundary[i].at == 0;
      places.back().push_back(corner ? 0.0 : panel.mirrored ? end[first + (i + n - 1) % n] : begin[first + i]);
    }
    first += n;
  }
  return places;
}

Eigen::Matrix2Xd as_drawn(const PanelMesh& panel, Eigen::Matrix2Xd at) {
  if (panel.mirrored) at.row(0) *= -1;
  return at;
}

Eigen::Matrix2Xd laid_on(const Eigen::Matrix2Xd& reference, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& at) {
  Eigen::Matrix2d map = Eigen::Matrix2d::Zero();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero(), wanted = Eigen::Vector2d::Zero();
  double area = 0;
  const auto edges = [&](const Eigen::Matrix2Xd& x, Eigen::Index t) {
    Eigen::Matrix2d e;
    e << x.col(triangles(1, t)) - x.col(triangles(0, t)), x.col(triangles(2, t)) - x.col(triangles(0, t));
    return e;
  };
  for (Eigen::Index t = 0; t < triangles.cols(); ++t) {
    const Eigen::Matrix2d from = edges(reference, t);
    const double weight = std::abs(from.determinant());
    map += weight * edges(at, t) * from.inverse();
    area += weight;
    for (int corner = 0; corner < 3; ++corner) {
      centre += weight / 3 * at.col(triangles(corner, t));
      wanted += weight / 3 * reference.col(triangles(corner, t));
    }
  }
  const double angle = std::atan2(map(1, 0) - map(0, 1), map(0, 0) + map(1, 1));
  return (Eigen::Rotation2Dd(-angle).toRotationMatrix() * (at.colwise() - centre / area)).colwise() + wanted / area;
}

}  // namespace toile
