#include "body/coherent_limbs.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "body/landmarks.h"
#include "geometry/topology.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

constexpr double widest_gap = 150 * std::numbers::pi / 180;  // an open front or a slit still surrounds
constexpr double closed_gap = 60 * std::numbers::pi / 180;   // half a skirt round one leg does not count as its trouser

std::vector<std::pair<int, int>> edges_of(const Eigen::Matrix3Xi& triangles) {
  std::vector<std::pair<int, int>> edges;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (Eigen::Index c = 0; c < 3; ++c) edges.emplace_back(std::minmax({triangles(c, t), triangles((c + 1) % 3, t)}));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<int> agreed(const Eigen::MatrixXd& cost, const std::vector<std::pair<int, int>>& edges) {
  const auto vertices = static_cast<std::size_t>(cost.cols());
  std::vector<std::vector<int>> beside(vertices);
  for (const auto& [a, b] : edges) {
    beside[static_cast<std::size_t>(a)].push_back(b);
    beside[static_cast<std::size_t>(b)].push_back(a);
  }
  std::vector<int> limb(vertices);
  const auto best = [&](std::size_t v, bool listen) {
    Eigen::VectorXd total = cost.col(static_cast<Eigen::Index>(v));
    if (listen && !beside[v].empty())
      for (const int other : beside[v]) {
        const double vote = limb_disagreement / static_cast<double>(beside[v].size());
        total.array() += vote;
        total[limb[static_cast<std::size_t>(other)]] -= vote;
      }
    Eigen::Index found = 0;
    total.minCoeff(&found);
    return static_cast<int>(found);
  };
  for (std::size_t v = 0; v < vertices; ++v) limb[v] = best(v, false);
  for (int round = 0; round < 20; ++round) {
    bool changed = false;
    for (std::size_t v = 0; v < vertices; ++v)
      if (const int now = best(v, true); now != limb[v]) {
        limb[v] = now;
        changed = true;
      }
    if (!changed) break;
  }
  return limb;
}

// Where the axis passes height y.
std::optional<Vec> passing(const LimbAxis& axis, double y) {
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const Vec &a = axis.points[i - 1], &b = axis.points[i];
    if ((a[1] - y) * (b[1] - y) <= 0 && a[1] != b[1]) return a + (a[1] - y) / (a[1] - b[1]) * (b - a);
  }
  return std::nullopt;
}

bool surrounds(const std::vector<int>& ring, const Eigen::Matrix3Xd& positions, const Vec& centre, double most_gap) {
  std::vector<double> angles;
  for (const int v : ring) angles.push_back(std::atan2(positions(0, v) - centre[0], positions(2, v) - centre[2]));
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  return gap < most_gap;
}

// Thickness of a slice in which every ring holds together; `level` by vertex, those below 0 do not count.
double slice_thickness(const Eigen::VectorXd& level, const std::vector<std::pair<int, int>>& edges) {
  std::vector<double> rise;
  for (const auto& [a, b] : edges)
    if (level(a) >= 0 && level(b) >= 0) rise.push_back(std::abs(level(a) - level(b)));
  if (rise.empty()) return 1e-3;
  std::sort(rise.begin(), rise.end());
  return std::max(2.2 * rise[rise.size() * 95 / 100], 1e-3);
}

// The vertices that hang together within slices of `thickness`, where `level` is not negative.
std::map<int, std::vector<int>> rings_of(const Eigen::VectorXd& level, double thickness,
                                         const std::vector<std::pair<int, int>>& edges) {
  const auto slice_of = [&](int v) { return std::floor(level(v) / thickness); };
  // Edges within a slice make its rings; `components` wants triangles, so an edge is given as a flat one.
  std::vector<std::pair<int, int>> kept;
  for (const auto& edge : edges)
    if (slice_of(edge.first) == slice_of(edge.second)) kept.push_back(edge);
  Eigen::Matrix3Xi strands(3, static_cast<Eigen::Index>(kept.size()));
  for (std::size_t e = 0; e < kept.size(); ++e)
    strands.col(static_cast<Eigen::Index>(e)) << kept[e].first, kept[e].second, kept[e].second;
  const std::vector<int> part = components(strands, static_cast<int>(level.size()));
  std::map<int, std::vector<int>> rings;
  for (int v = 0; v < static_cast<int>(level.size()); ++v)
    if (level(v) >= 0) rings[part[static_cast<std::size_t>(v)]].push_back(v);
  return rings;
}

class Rings {
 public:
  Rings(const Mannequin& form, const std::vector<LimbAxis>& axes) : axes_(axes) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (axes[i].name == "trunk") trunk_ = static_cast<int>(i);
      if (axes[i].name.rfind("leg.", 0) == 0) legs_.push_back(static_cast<int>(i));
      if (axes[i].name.rfind("arm.", 0) == 0) arms_.push_back(static_cast<int>(i));
    }
    const UprightExtent extent = upright_extent(form);
    const auto level = [&](const char* name, double share) {
      const auto found = form.landmarks.find(name);
      return found != form.landmarks.end() ? found->second : extent.low + share * (extent.high - extent.low);
    };
    armpit_ = level("armpit", .755);
    crotch_ = level("crotch", .45);
  }

  bool applies() const { return trunk_ >= 0 && !legs_.empty(); }
  double top() const { return armpit_; }

  bool surround(const std::vector<int>& vertices, int limb, const Eigen::Matrix3Xd& positions, double y,
                double most_gap) const {
    const auto centre = passing(axes_[static_cast<std::size_t>(limb)], y);
    return centre && surrounds(vertices, positions, *centre, most_gap);
  }

  // The limb that a ring at height y surrounds, -1 when it surrounds none.
  int surrounded(const std::vector<int>& ring, const Eigen::Matrix3Xd& positions, double y) const {
    const auto within = [&](int limb) { return surround(ring, limb, positions, y, widest_gap); };
    if (y > crotch_ && within(trunk_)) return trunk_;
    int found = -1, legs = 0;
    if (y <= crotch_)
      for (const int leg : legs_)
        if (within(leg)) {
          found = leg;
          ++legs;
        }
    if (legs > 1) return trunk_;
    for (const int arm : arms_)
      if (within(arm)) found = found < 0 ? arm : trunk_;
    return found;
  }

 private:
  const std::vector<LimbAxis>& axes_;
  int trunk_ = -1;
  std::vector<int> legs_, arms_;
  double armpit_ = 0, crotch_ = 0;
};

void follow_rings(const Rings& rings, const Eigen::Matrix3Xd& positions, const std::vector<std::pair<int, int>>& edges,
                  std::vector<int>& limb) {
  const Eigen::VectorXd below = (rings.top() - positions.row(1).array()).matrix().transpose();
  const double thickness = slice_thickness(below, edges);
  for (const auto& [unused, ring] : rings_of(below, thickness, edges)) {
    const double y = rings.top() - (std::floor(below(ring.front()) / thickness) + .5) * thickness;
    const int found = rings.surrounded(ring, positions, y);
    if (found < 0) continue;
    // Where a sleeve or a trouser leg joins, the slice holds both: vertices that surround their own limb by themselves keep it.
    std::map<int, std::vector<int>> by_limb;
    for (const int v : ring) by_limb[limb[static_cast<std::size_t>(v)]].push_back(v);
    for (const auto& [own, vertices] : by_limb)
      if (own == found || !rings.surround(vertices, own, positions, y, closed_gap))
        for (const int v : vertices) limb[static_cast<std::size_t>(v)] = found;
  }
}

// A sleeve is round its arm, square to it: slices at a level miss that where an arm is spread and the sleeve ends.
void follow_sleeves(const std::vector<LimbAxis>& axes, const Eigen::Matrix3Xd& positions,
                    const std::vector<std::pair<int, int>>& edges, std::vector<int>& limb) {
  constexpr double widest = 0.2;  // m from the arm
  for (std::size_t arm = 0; arm < axes.size(); ++arm) {
    if (axes[arm].name.rfind("arm.", 0) != 0) continue;
    const std::vector<Vec>& points = axes[arm].points;
    const Vec start = points.front(), way = (points[std::min<std::size_t>(2, points.size() - 1)] - start).normalized();
    const Vec across = way.cross(Vec::UnitZ()).normalized(), forward = across.cross(way);
    const Eigen::VectorXd along = (way.transpose() * (positions.colwise() - start)).transpose();
    std::vector<char> sleeve(limb.size(), 0);
    double begins = std::numeric_limits<double>::infinity();
    for (const auto& [unused, ring] : rings_of(along, slice_thickness(along, edges), edges)) {
      Eigen::Matrix3Xd seen(3, static_cast<Eigen::Index>(ring.size()));  // x and z across the arm
      std::vector<int> all;
      double far = 0;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        Vec nearest = start;
        for (std::size_t p = 1; p < points.size(); ++p) {
          const Vec bone = points[p] - points[p - 1];
          const double t = std::clamp((positions.col(ring[i]) - points[p - 1]).dot(bone) / bone.squaredNorm(), 0.0, 1.0);
          const Vec at = points[p - 1] + t * bone;
          if (p == 1 || (positions.col(ring[i]) - at).norm() < (positions.col(ring[i]) - nearest).norm()) nearest = at;
        }
        const Vec off = positions.col(ring[i]) - nearest;
        seen.col(static_cast<Eigen::Index>(i)) << off.dot(across), 0, off.dot(forward);
        far = std::max(far, off.norm());
        all.push_back(static_cast<int>(i));
      }
      if (far > widest || !surrounds(all, seen, Vec::Zero(), closed_gap)) continue;
      for (const int v : ring) {
        limb[static_cast<std::size_t>(v)] = static_cast<int>(arm);
        sleeve[static_cast<std::size_t>(v)] = 1;
        begins = std::min(begins, along(v));
      }
    }
    // What hangs on the sleeve alone: the corners of a cuff that is not square to the arm.
    Eigen::VectorXd beside = along;
    for (Eigen::Index v = 0; v < beside.size(); ++v) beside(v) = sleeve[static_cast<std::size_t>(v)] ? -1 : 0;
    for (const auto& [unused, part] : rings_of(beside, 1, edges))
      if (std::all_of(part.begin(), part.end(), [&](int v) { return along(v) > begins; }))
        for (const int v : part) limb[static_cast<std::size_t>(v)] = static_cast<int>(arm);
  }
}

}  // namespace

std::vector<int> coherent_limbs(const Mannequin& form, const std::vector<LimbAxis>& axes, const Eigen::MatrixXd& cost,
                                const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles) {
  const std::vector<std::pair<int, int>> edges = edges_of(triangles);
  std::vector<int> limb = agreed(cost, edges);
  if (edges.empty()) return limb;
  if (const Rings rings(form, axes); rings.applies()) follow_rings(rings, positions, edges, limb);
  follow_sleeves(axes, positions, edges, limb);
  return limb;
}

}  // namespace toile
