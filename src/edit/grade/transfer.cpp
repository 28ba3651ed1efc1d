#include "edit/grade/transfer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "edit/reach.h"
#include "style/soft_terms.h"

namespace toile {
namespace {

// The same point of the triangles, on `to`.
Eigen::Vector3d same_point(const Body& from, const Body& to, const Eigen::Vector3d& on_skin) {
  const NearestPoint nearest = from.skin.nearest(on_skin);
  const Eigen::Vector3i corners = from.form.triangles.col(nearest.triangle);
  const Eigen::Vector3d a = from.form.positions.col(corners(0));
  const Eigen::Vector3d u = from.form.positions.col(corners(1)) - a, v = from.form.positions.col(corners(2)) - a;
  const Eigen::Vector3d normal = u.cross(v);
  const double twice = std::max(1e-18, normal.squaredNorm());
  const double second = (nearest.at - a).cross(v).dot(normal) / twice, third = u.cross(nearest.at - a).dot(normal) / twice;
  // What is left of the point off its triangle is kept: none for points of the skin.
  return (1 - second - third) * to.form.positions.col(corners(0)) + second * to.form.positions.col(corners(1)) +
         third * to.form.positions.col(corners(2)) + (on_skin - nearest.at);
}

// Where the ray from the bone leaves the skin, m from the bone, nearest to where it did on the other body.
std::optional<double> skin_on_ray(const Body& body, const Eigen::Vector3d& bone, const Eigen::Vector3d& outward,
                                  double expected) {
  std::optional<double> best;
  for (const double t : body.skin.crossings(bone, outward, 3 * expected + 0.3))
    if (!best || std::abs(t - expected) < std::abs(*best - expected)) best = t;
  return best;
}

// Unknown columns as the smoothest continuation of the known ones.
void fill(const VertexNeighbours& neighbours, const std::vector<bool>& known, Eigen::Matrix3Xd& field) {
  std::vector<int> unknown;
  for (std::size_t v = 0; v < known.size(); ++v)
    if (!known[v]) unknown.push_back(static_cast<int>(v));
  if (unknown.empty() || unknown.size() == known.size()) return;
  // First the nearest known, ring by ring; then even out.
  std::vector<bool> reached_now = known;
  for (bool any = true; any;) {
    any = false;
    std::vector<int> added;
    for (const int v : unknown) {
      if (reached_now[static_cast<std::size_t>(v)]) continue;
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      int count = 0;
      for (const int w : neighbours[static_cast<std::size_t>(v)])
        if (reached_now[static_cast<std::size_t>(w)]) {
          sum += field.col(w);
          ++count;
        }
      if (count == 0) continue;
      field.col(v) = sum / count;
      added.push_back(v);
    }
    for (const int v : added) reached_now[static_cast<std::size_t>(v)] = any = true;
  }
  for (int round = 0; round < 300; ++round)
    for (const int v : unknown) {
      const auto& around = neighbours[static_cast<std::size_t>(v)];
      if (around.empty()) continue;
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const int w : around) mean += field.col(w) / static_cast<double>(around.size());
      field.col(v) = mean;
    }
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// No longer known: what moves otherwise than the cloth about it, because its ray met another limb's skin.
void reject_strays(const VertexNeighbours& neighbours, const Eigen::Matrix3Xd& drape, const Eigen::Matrix3Xd& moved,
                   std::vector<bool>& known) {
  constexpr std::size_t rings = 3;
  constexpr int passes = 2;
  constexpr double slope = 0.3;    // of the displacement; bodies and sizes change by less
  constexpr double always = 2e-3;  // m
  std::vector<int> seen(known.size(), -1);
  for (int pass = 0; pass < passes; ++pass) {
    std::vector<bool> kept = known;
    for (std::size_t v = 0; v < known.size(); ++v) {
      if (!known[v]) continue;
      const auto column = static_cast<Eigen::Index>(v);
      const int mark = static_cast<int>(v) + pass * static_cast<int>(known.size());
      std::vector<int> around{static_cast<int>(v)};
      seen[v] = mark;
      for (std::size_t ring = 0, next = 0; ring < rings; ++ring)
        for (const std::size_t end = around.size(); next < end; ++next)
          for (const int w : neighbours[static_cast<std::size_t>(around[next])])
            if (std::exchange(seen[static_cast<std::size_t>(w)], mark) != mark) around.push_back(w);
      std::array<std::vector<double>, 3> by;
      double far = 0;
      for (const int w : around) {
        if (w == static_cast<int>(v) || !known[static_cast<std::size_t>(w)]) continue;
        for (int i = 0; i < 3; ++i) by[static_cast<std::size_t>(i)].push_back(moved(i, w));
        far += (drape.col(w) - drape.col(column)).norm();
      }
      if (by[0].size() < 4) continue;
      const Eigen::Vector3d usual(median(by[0]), median(by[1]), median(by[2]));
      far /= static_cast<double>(by[0].size());
      kept[v] = (moved.col(column) - usual).norm() <= slope * far + always;
    }
    known = std::move(kept);
  }
}

// Evens out the displacement: bones and skin below the cloth change from vertex to vertex, bodies from a few centimetres to the
// next. What lies on the body is brought back to it by the fit.
void even_out(const VertexNeighbours& neighbours, const Eigen::Matrix3Xd& drape, Eigen::Matrix3Xd& moved) {
  constexpr double radius = 0.06;  // m
  double length = 0, count = 0;
  for (std::size_t v = 0; v < neighbours.size(); ++v)
    for (const int w : neighbours[v]) {
      length += (drape.col(static_cast<Eigen::Index>(v)) - drape.col(w)).norm();
      ++count;
    }
  const double steps = radius * count / std::max(1e-9, length);
  for (int round = static_cast<int>(std::lround(steps * steps)); round > 0; --round) {
    Eigen::Matrix3Xd next = moved;
    for (std::size_t v = 0; v < neighbours.size(); ++v) {
      if (neighbours[v].empty()) continue;
      const auto column = static_cast<Eigen::Index>(v);
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const int w : neighbours[v]) mean += moved.col(w) / static_cast<double>(neighbours[v].size());
      next.col(column) += 0.5 * (mean - moved.col(column));
    }
    moved = std::move(next);
  }
}

// Evened out, so that the triangles over a shoulder turn by degrees from the trunk's pose to the arm's.
void even_out(const VertexNeighbours& neighbours, std::vector<Eigen::Matrix3d>& turn) {
  Eigen::Matrix3Xd field(3, static_cast<Eigen::Index>(turn.size()));
  for (std::size_t v = 0; v < turn.size(); ++v) {
    const Eigen::AngleAxisd way(turn[v]);
    field.col(static_cast<Eigen::Index>(v)) = way.angle() * way.axis();
  }
  for (int round = 0; round < 20; ++round) {
    Eigen::Matrix3Xd next = field;
    for (std::size_t v = 0; v < turn.size(); ++v) {
      if (neighbours[v].empty()) continue;
      Eigen::Vector3d mean = Eigen::Vector3d::Zero();
      for (const int w : neighbours[v]) mean += field.col(w) / static_cast<double>(neighbours[v].size());
      next.col(static_cast<Eigen::Index>(v)) = (field.col(static_cast<Eigen::Index>(v)) + mean) / 2;
    }
    field = std::move(next);
  }
  for (std::size_t v = 0; v < turn.size(); ++v) {
    const Eigen::Vector3d way = field.col(static_cast<Eigen::Index>(v));
    turn[v] =
        way.norm() < 1e-12 ? Eigen::Matrix3d::Identity() : Eigen::AngleAxisd(way.norm(), way.normalized()).toRotationMatrix();
  }
}

}  // namespace

bool same_topology(const Mannequin& a, const Mannequin& b) {
  return a.positions.cols() == b.positions.cols() && a.triangles.cols() == b.triangles.cols() && a.triangles == b.triangles;
}

Transferred transfer(const EditInput& input, const std::vector<RelativePlace>& places, const Body& to, const LimbMap& map) {
  const Eigen::Index count = input.drape.cols();
  const VertexNeighbours neighbours = neighbours_of(level_mesh(input.garment.triangles), count);
  const bool alike = same_topology(input.body.form, to.form);
  Transferred result;
  result.axis.resize(3, count);
  result.level.resize(count);
  Eigen::Matrix3Xd moved = Eigen::Matrix3Xd::Zero(3, count);
  std::vector<bool> known(static_cast<std::size_t>(count), false);
  for (Eigen::Index v = 0; v < count; ++v) {
    const RelativePlace& place = places[static_cast<std::size_t>(v)];
    const MappedBone bone = map.at(place);
    const Eigen::Vector3d outward = bone.turn * place.outward;
    result.turn.push_back(bone.turn);
    result.axis.col(v) = bone.axis;
    result.level(v) = bone.axis.dot(bone.on_axis) + place.beyond;
    if (!place.through_skin) continue;
    const auto skin = skin_on_ray(to, bone.on_axis, outward, (place.on_skin - place.on_axis).norm());
    const double own = alike ? 1 - smoothstep(place.offset, 0.02, 0.10) : 0;  // share of the skin's own points
    if (!skin && !(own >= 1)) continue;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    if (own < 1) at += (1 - own) * (bone.on_axis + (*skin + place.offset) * outward);
    if (own > 0) at += own * (same_point(input.body, to, place.on_skin) + place.offset * outward);
    moved.col(v) = at - input.drape.col(v);
    known[static_cast<std::size_t>(v)] = true;
  }
  reject_strays(neighbours, input.drape, moved, known);
  fill(neighbours, known, moved);
  even_out(neighbours, input.drape, moved);
  result.positions = input.drape + moved;
  for (Eigen::Index v = 0; v < count; ++v) {
    const double now = result.axis.col(v).dot(result.positions.col(v));
    if (known[static_cast<std::size_t>(v)])
      result.level(v) = now * (1 - smoothstep(places[static_cast<std::size_t>(v)].offset, 0.02, 0.10)) +
                        result.level(v) * smoothstep(places[static_cast<std::size_t>(v)].offset, 0.02, 0.10);
    else
      result.positions.col(v) += (result.level(v) - now) * result.axis.col(v);
  }
  even_out(neighbours, result.turn);
  return result;
}

}  // namespace toile
