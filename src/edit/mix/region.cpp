#include "edit/mix/region.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "edit/mix/cut_line.h"
#include "edit/mix/min_cut.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double normals_weight = 0.4;  // tau_n
constexpr double arm = 0.15;            // m, at which an angle counts as a distance
constexpr double near = 0.04;           // m, beyond which the other garment is not there
constexpr int waves = 6;                // of the smooth line, on the way round

Eigen::Vector3d normal_of(const EditInput& input, Eigen::Index t) {
  const Eigen::Vector3d a = input.drape.col(input.garment.triangles(0, t));
  return Eigen::Vector3d(input.drape.col(input.garment.triangles(1, t)) - a)
      .cross(input.drape.col(input.garment.triangles(2, t)) - a)
      .normalized();
}

Eigen::Vector3d centre_of(const EditInput& input, Eigen::Index t) {
  return (input.drape.col(input.garment.triangles(0, t)) + input.drape.col(input.garment.triangles(1, t)) +
          input.drape.col(input.garment.triangles(2, t))) /
         3;
}

// The other garment's normals by place on the limb.
class NormalsByPlace {
 public:
  NormalsByPlace(const EditInput& input, const LimbAxis& axis, const LimbCurve& from, const LimbCurve& to) {
    for (Eigen::Index t = 0; t < input.garment.triangles.cols(); ++t) {
      const LimbPlace place = limb_place(input.body, axis, from.limb, centre_of(input, t));
      const double low = along_at(from, place.angle), high = along_at(to, place.angle);
      if (place.along < low - near || place.along > high + near) continue;
      found_[cell(place)].push_back({place, normal_of(input, t)});
    }
  }

  std::optional<Eigen::Vector3d> at(const LimbPlace& place) const {
    const auto [row, column] = cell(place);
    double nearest = near;
    std::optional<Eigen::Vector3d> best;
    for (int r = row - 1; r <= row + 1; ++r)
      for (int c = column - 1; c <= column + 1; ++c) {
        const auto entries = found_.find({r, (c % columns() + columns()) % columns()});
        if (entries == found_.end()) continue;
        for (const auto& [other, normal] : entries->second) {
          const double round = std::remainder(other.angle - place.angle, 2 * std::numbers::pi) * arm;
          const double distance = std::hypot(other.along - place.along, round);
          if (distance >= nearest) continue;
          nearest = distance;
          best = normal;
        }
      }
    return best;
  }

 private:
  static int columns() { return static_cast<int>(2 * std::numbers::pi * arm / near); }
  static std::pair<int, int> cell(const LimbPlace& place) {
    const int column = static_cast<int>(std::floor((place.angle / (2 * std::numbers::pi) + 0.5) * columns()));
    return {static_cast<int>(std::floor(place.along / near)), (column % columns() + columns()) % columns()};
  }
  std::map<std::pair<int, int>, std::vector<std::pair<LimbPlace, Eigen::Vector3d>>> found_;
};

// 0: before the region or on another limb, 1: beyond it, -1: in it.
std::vector<int> sides_to_keep(const EditInput& input, const std::vector<LimbAxis>& axes, const LimbCurve& from,
                               const LimbCurve& to) {
  const auto places = relative_places(input.body, input.drape, input.garment.triangles);
  const auto elsewhere = [&](int v) {
    const int limb = places[static_cast<std::size_t>(v)].limb;
    if (limb == from.limb) return false;
    return from.limb != 0 || axes[static_cast<std::size_t>(limb)].name.rfind("arm", 0) == 0;
  };
  std::vector<int> must;
  for (Eigen::Index t = 0; t < input.garment.triangles.cols(); ++t) {
    const LimbPlace place = limb_place(input.body, axes[static_cast<std::size_t>(from.limb)], from.limb, centre_of(input, t));
    int side = place.along < along_at(from, place.angle) ? 0 : place.along > along_at(to, place.angle) ? 1 : -1;
    for (int k = 0; k < 3; ++k)
      if (elsewhere(input.garment.triangles(k, t))) side = 0;
    must.push_back(side);
  }
  return must;
}

std::vector<VertexLoop> closed_loops(const std::vector<MeshEdge>& edges, const std::vector<int>& sides) {
  std::map<int, std::vector<int>> next;
  std::array<int, 2> last{-1, -1};  // where several pieces are sewn into one seam there is one line
  for (const MeshEdge& edge : edges)
    if (edge.triangle[1] >= 0 &&
        sides[static_cast<std::size_t>(edge.triangle[0])] != sides[static_cast<std::size_t>(edge.triangle[1])] &&
        std::exchange(last, edge.vertex) != edge.vertex) {
      next[edge.vertex[0]].push_back(edge.vertex[1]);
      next[edge.vertex[1]].push_back(edge.vertex[0]);
    }
  std::vector<VertexLoop> loops;
  for (auto& [start, ways] : next) {
    VertexLoop loop;
    int at = start;
    while (!next[at].empty()) {
      const int to = next[at].back();
      next[at].pop_back();
      auto& back = next[to];
      back.erase(std::find(back.begin(), back.end(), at));
      loop.push_back(at);
      at = to;
    }
    if (loop.size() >= 3 && at == start) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

RegionCut cut_in_region(const EditInput& first, const EditInput& second, const LimbCurve& from, const LimbCurve& to,
                        const std::string& place) {
  const auto bad = [&](const std::string& text) {
    throw BadInput(
        {"edit.bad-region", Severity::error, place, text,
         "name two loops or levels round the same limb, such as \"waist..hip\", the nearer to the trunk or head first"});
  };
  if (from.limb != to.limb) bad("the two ends of the region are not round the same limb");
  for (std::size_t i = 0; i < from.along.size(); ++i)
    if (from.along[i] >= to.along[i]) bad("the region has no width: its first end is not before its second everywhere");
  const auto axes = trunk_and_limbs(first.body.form);
  const LimbAxis& axis = axes[static_cast<std::size_t>(from.limb)];
  const std::vector<int> must = sides_to_keep(first, axes, from, to);
  const NormalsByPlace other(second, axis, from, to);
  const std::vector<MeshEdge> edges = mesh_edges(first.garment.triangles);
  std::vector<CutEdge> costs, lengths;
  std::vector<double> turned(edges.size(), 0);
  int there = 0, asked = 0;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto [a, b] = edges[e].triangle;
    if (b < 0) continue;
    const Eigen::Vector3d u = first.drape.col(edges[e].vertex[0]), v = first.drape.col(edges[e].vertex[1]);
    const double size = (u - v).norm() / first.body.form.height;
    double differ = 2;
    if (must[static_cast<std::size_t>(a)] < 0 || must[static_cast<std::size_t>(b)] < 0) {
      const auto normal = other.at(limb_place(first.body, axis, from.limb, (u + v) / 2));
      ++asked;
      if (normal) {
        ++there;
        const double along = (normal_of(first, a) + normal_of(first, b)).normalized().dot(*normal);
        differ = std::abs(1 - along);
        turned[e] = std::acos(std::clamp(along, -1.0, 1.0));
      }
    }
    costs.push_back({a, b, normals_weight * differ + size});
    lengths.push_back({a, b, size});
  }
  if (asked == 0) bad("nothing of the garment is between the two ends of the region");
  if (there == 0)
    throw BadInput({"edit.no-overlap", Severity::error, place, "the other garment has nothing in that region of the body",
                    "choose a region where both garments are"});
  const auto longest_loop = [&](const std::vector<int>& sides) {
    VertexLoop best;
    for (VertexLoop& loop : closed_loops(edges, sides))
      if (loop.size() > best.size() && limb_inside(first.body, axes, points_of(loop, first.drape)) == from.limb)
        best = std::move(loop);
    return best;
  };
  const auto length_of = [&](const VertexLoop& loop) {
    double sum = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      sum += (first.drape.col(loop[i]) - first.drape.col(loop[(i + 1) % loop.size()])).norm();
    return sum;
  };
  const std::vector<int> sides = min_cut(must, costs);
  const VertexLoop loop = longest_loop(sides);
  if (loop.empty()) bad("the garment does not close round the limb within the region");
  RegionCut cut;
  double count = 0;
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (edges[e].triangle[1] >= 0 &&
        sides[static_cast<std::size_t>(edges[e].triangle[0])] != sides[static_cast<std::size_t>(edges[e].triangle[1])]) {
      cut.turned += turned[e];
      ++count;
    }
  cut.turned /= std::max(1.0, count);
  cut.length = length_of(loop);
  cut.shortest = length_of(longest_loop(min_cut(must, lengths)));
  cut.curve = smoothed(limb_curve(first.body, axes, points_of(loop, first.drape)), waves);
  return cut;
}

}  // namespace toile
