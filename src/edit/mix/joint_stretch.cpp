#include "edit/mix/joint_stretch.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace toile {
namespace {

constexpr double end = 1e-9;  // share of an edge

// Garment vertices of the seam's first side, from its begin to its end.
std::vector<int> vertices_of(const Pattern& pattern, const GarmentMesh& garment, const EdgeSpan& span) {
  const Piece* piece = find_piece(pattern, span.piece);
  const auto index = static_cast<int>(piece - pattern.pieces.data());
  const auto edge = static_cast<int>(find_edge(*piece, span.edge) - piece->outline.data());
  const auto count = static_cast<int>(piece->outline.size());
  const double low = std::min(span.begin, span.end) - end, high = std::max(span.begin, span.end) + end;
  std::vector<std::pair<double, int>> along;
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    if (panel.piece != index || panel.copy != span.copy) continue;
    for (const BoundaryVertex& v : panel.boundary) {
      if (v.edge == edge && v.at >= low && v.at <= high) along.emplace_back(v.at, garment.welded[p](v.vertex));
      if (v.edge == (edge + 1) % count && v.at <= end && high >= 1) along.emplace_back(1, garment.welded[p](v.vertex));
    }
  }
  std::sort(along.begin(), along.end());
  std::vector<int> vertices;
  for (const auto& [at, vertex] : along) vertices.push_back(vertex);
  return vertices;
}

double angle_at(const Eigen::Vector3d& at, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a - at, v = b - at;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

}  // namespace

JointStretch joint_stretch(const Pattern& pattern, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, int seam,
                           double reach) {
  JointStretch stretch;
  stretch.seam = seam;
  const Seam& joint = pattern.seams[static_cast<std::size_t>(seam)];
  const std::vector<int> line = vertices_of(pattern, garment, joint.a);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    stretch.length += (positions.col(line[i + 1]) - positions.col(line[i])).norm();
  const std::vector<int> offsets = triangle_offsets(garment);
  std::set<int> edge, near, beside;  // of both panels: on their outlines, within reach, and what a triangle joins to these
  const std::set<int> on_line(line.begin(), line.end());
  std::vector<std::size_t> panels;
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    for (const EdgeSpan* span : {&joint.a, &joint.b}) {
      const PanelMesh& panel = garment.panels[p];
      if (pattern.pieces[static_cast<std::size_t>(panel.piece)].name != span->piece || panel.copy != span->copy) continue;
      panels.push_back(p);
      for (const BoundaryVertex& v : panel.boundary) edge.insert(garment.welded[p](v.vertex));
    }
  std::map<int, std::size_t> place;  // along the line
  const auto place_of = [&](int v) {
    if (const auto found = place.find(v); found != place.end()) return found->second;
    std::size_t best = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
      if ((positions.col(line[i]) - positions.col(v)).norm() < (positions.col(line[best]) - positions.col(v)).norm()) best = i;
    return place[v] = best;
  };
  std::map<int, double> defect;
  for (const std::size_t p : panels)
    for (int t = offsets[p]; t < offsets[p + 1]; ++t)
      for (int k = 0; k < 3; ++k) {
        const int v = garment.triangles(k, t);
        if ((positions.col(line[place_of(v)]) - positions.col(v)).norm() < reach) near.insert(v);
        defect.emplace(v, 2 * std::numbers::pi).first->second -=
            angle_at(positions.col(v), positions.col(garment.triangles((k + 1) % 3, t)),
                     positions.col(garment.triangles((k + 2) % 3, t)));
      }
  for (const std::size_t p : panels)
    for (int t = offsets[p]; t < offsets[p + 1]; ++t)
      for (int k = 0; k < 3; ++k)
        if (near.count(garment.triangles(k, t)))
          for (int other = 0; other < 3; ++other) beside.insert(garment.triangles(other, t));
  std::vector<double> along(line.size(), 0);
  for (const int v : beside)
    if (!edge.count(v) || (on_line.count(v) && v != line.front() && v != line.back())) along[place_of(v)] += defect.at(v);
  double most = 0, least = 0;  // sums that end here
  for (const double here : along) {
    stretch.curvature += here;
    most = std::max(0.0, most + here);
    least = std::min(0.0, least + here);
    stretch.turns_apart = std::max({stretch.turns_apart, most, -least});
  }
  return stretch;
}

std::set<int> vertices_of_seam(const Pattern& pattern, const GarmentMesh& garment, int seam) {
  const std::vector<int> vertices = vertices_of(pattern, garment, pattern.seams[static_cast<std::size_t>(seam)].a);
  return {vertices.begin(), vertices.end()};
}

std::optional<PieceJoin> whole_edges(const Pattern& pattern, int seam) {
  const Seam& joint = pattern.seams[static_cast<std::size_t>(seam)];
  const auto whole = [](const EdgeSpan& span) {
    return std::min(span.begin, span.end) < end && std::max(span.begin, span.end) > 1 - end;
  };
  if (!whole(joint.a) || !whole(joint.b) || joint.a.piece == joint.b.piece || joint.right_to_wrong) return std::nullopt;
  const Piece *a = find_piece(pattern, joint.a.piece), *b = find_piece(pattern, joint.b.piece);
  PieceJoin join;
  join.base = static_cast<int>(a - pattern.pieces.data());
  join.other = static_cast<int>(b - pattern.pieces.data());
  join.base_edge = static_cast<int>(find_edge(*a, joint.a.edge) - a->outline.data());
  join.other_edge = static_cast<int>(find_edge(*b, joint.b.edge) - b->outline.data());
  join.reflected = is_mirrored(*a, joint.a.copy) != is_mirrored(*b, joint.b.copy);
  join.copies = {{joint.a.copy, joint.b.copy}};
  if (signed_area(*b) > signed_area(*a)) {
    std::swap(join.base, join.other);
    std::swap(join.base_edge, join.other_edge);
    std::swap(join.copies[0].first, join.copies[0].second);
  }
  const bool same_way = (joint.a.begin < joint.a.end) == (joint.b.begin < joint.b.end);
  if (same_way != join.reflected || a->outline.size() < 2 || b->outline.size() < 2) return std::nullopt;
  return join;
}

}  // namespace toile
