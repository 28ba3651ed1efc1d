#include "edit/mix/mix_loops.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

#include "edit/account.h"
#include "edit/loops.h"
#include "edit/mix/limb_curve.h"
#include "edit/mix/parting.h"
#include "edit/mix/region.h"
#include "edit/worn_loops.h"
#include "garment/units.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double beside_seam = 25e-3;  // m, lines this near to a seam are moved there
constexpr double within_reach = 0.10;  // m, a free edge this near is taken when the garment ends before the loop

// The loops that a name means: its edges, or the line where its level cuts the garment.
std::vector<CutLoop> named_loops(const EditInput& input, const std::string& name, const std::string& place) {
  const NamedLoops named = resolve_loops(input, name, place);
  std::vector<CutLoop> loops;
  if (!named.level) {
    for (const VertexLoop& loop : named.loops) loops.push_back({loop, {}});
    return loops;
  }
  const auto axes = trunk_and_limbs(input.body.form);
  for (const VertexLoop& loop : named.loops) {
    const auto near = points_of(loop, input.drape);
    const int limb = limb_inside(input.body, axes, near);
    const bool upright = named.level->normal().y() > 0.999;
    const double sign = upright ? -1 : 1;  // limbs run down, and out
    const Eigen::VectorXd field =
        sign * ((named.level->normal().transpose() * input.drape).array() + named.level->offset()).matrix().transpose();
    const Eigen::Vector3d middle = loop_centre(input.drape, loop);
    CutLine best;
    double nearest = std::numeric_limits<double>::infinity();
    for (CutLine& line : cut_lines(input.garment.triangles, field)) {
      const auto points = points_of(line, input.drape);
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (const Eigen::Vector3d& point : points) centre += point / static_cast<double>(points.size());
      if (limb_inside(input.body, axes, points) != limb || (centre - middle).norm() > nearest) continue;
      nearest = (centre - middle).norm();
      best = std::move(line);
    }
    if (!best.empty()) loops.push_back({{}, std::move(best)});
  }
  return moved_to_seams(input, loops, beside_seam, place);
}

// The line of `input` at the same place of the body as `curve`.
CutLoop line_at(const EditInput& input, const std::vector<LimbAxis>& axes, const LimbCurve& curve, const std::string& place) {
  Eigen::VectorXd far = beyond(input.body, axes, curve, input.drape);
  // What lies along an arm but is cloth of the trunk is not beyond its armhole.
  const auto places = relative_places(input.body, input.drape, input.garment.triangles);
  for (Eigen::Index v = 0; curve.limb != 0 && v < far.size(); ++v)
    if (places[static_cast<std::size_t>(v)].limb != curve.limb) far(v) = -std::abs(far(v)) - 1e-4;
  const auto off = [&](const std::vector<Eigen::Vector3d>& points) {
    double sum = 0;
    for (const Eigen::Vector3d& point : points) {
      const LimbPlace at = limb_place(input.body, axes[static_cast<std::size_t>(curve.limb)], curve.limb, point);
      sum += std::abs(at.along - along_at(curve, at.angle)) / static_cast<double>(points.size());
    }
    return sum;
  };
  CutLine longest;
  for (CutLine& line : cut_lines(input.garment.triangles, far))
    if (line.size() > longest.size() && limb_inside(input.body, axes, points_of(line, input.drape)) == curve.limb)
      longest = std::move(line);
  if (!longest.empty()) return moved_to_seams(input, {{{}, longest}}, beside_seam, place).front();
  VertexLoop best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const VertexLoop& edge : boundary_loops(input.garment.triangles)) {
    const auto points = points_of(edge, input.drape);
    if (limb_inside(input.body, axes, points) != curve.limb || off(points) > nearest) continue;
    nearest = off(points);
    best = edge;
  }
  if (best.empty() || nearest > within_reach)
    throw BadInput({"edit.no-overlap", Severity::error, place,
                    best.empty() ? "the other garment has nothing round that limb of the body"
                                 : "the other garment ends " + in_mm(nearest, 0) + " away from that loop",
                    "name the loop of the other garment (other_loop), or choose a garment that reaches there"});
  return {best, {}};
}

// A seam or edge of the second garment that is called as the first one's and hangs near it.
std::optional<CutLoop> namesake(const EditInput& first, const EditInput& second, const CutLoop& own, const std::string& name) {
  constexpr double near = 0.05;  // m
  if (own.seam.empty()) return std::nullopt;
  const Eigen::Vector3d centre = loop_centre(first.drape, own.seam);
  try {
    const NamedLoops named = resolve_loops(second, name, "");
    for (const VertexLoop& loop : named.loops)
      if (!named.level && (loop_centre(second.drape, loop) - centre).norm() < near) return CutLoop{loop, {}};
  } catch (const BadInput&) {
  }
  return std::nullopt;
}

// Where the second garment's sleeve or collar begins, when the loop is where the first one's does: however their edges are
// called, and however far down the arm either is cut.
std::optional<CutLoop> worn_alike(const EditInput& first, const EditInput& second, const CutLoop& own) {
  constexpr double share = 0.8;  // of the loop's vertices
  if (own.seam.empty()) return std::nullopt;
  const std::set<int> vertices(own.seam.begin(), own.seam.end());
  const auto is_own = [&](const VertexLoop& loop) {
    const auto met = std::count_if(loop.begin(), loop.end(), [&](int v) { return vertices.count(v) > 0; });
    return static_cast<double>(met) > share * static_cast<double>(std::max(loop.size(), vertices.size()));
  };
  for (const Armhole& armhole : armholes(first))
    if (is_own(armhole.loop))
      for (const Armhole& other : armholes(second))
        if (other.left == armhole.left) return CutLoop{other.loop, {}};
  for (const VertexLoop& neck : necklines(first))
    if (is_own(neck))
      for (const VertexLoop& other : necklines(second)) return CutLoop{other, {}};
  return std::nullopt;
}

}  // namespace

MixLoops mix_loops(const EditInput& first, const EditInput& second, const std::string& loop, const std::string& other_loop) {
  const auto axes = trunk_and_limbs(first.body.form);
  MixLoops loops;
  loops.first = named_loops(first, loop, "edit 'mix', loop");
  if (other_loop == "auto") {
    for (const CutLoop& own : loops.first) {
      auto same = namesake(first, second, own, loop);
      if (!same) same = worn_alike(first, second, own);
      loops.second.push_back(
          same ? *same : line_at(second, axes, limb_curve(first.body, axes, points_of(own, first.drape)), "edit 'mix', loop"));
    }
    return loops;
  }
  std::vector<CutLoop> named = named_loops(second, other_loop, "edit 'mix', other_loop");
  for (const CutLoop& own : loops.first) {
    const int limb = limb_inside(first.body, axes, points_of(own, first.drape));
    const auto found = std::find_if(named.begin(), named.end(), [&](const CutLoop& other) {
      return limb_inside(second.body, axes, points_of(other, second.drape)) == limb;
    });
    if (found == named.end())
      throw BadInput({"edit.other-loops", Severity::error, "edit 'mix', other_loop",
                      "'" + other_loop + "' is not round the same limb as '" + loop + "'",
                      "name loops of both garments round the same limb: waist and waist, armholes and armholes"});
    loops.second.push_back(std::move(*found));
    named.erase(found);
  }
  if (!named.empty())
    throw BadInput({"edit.other-loops", Severity::error, "edit 'mix', other_loop",
                    "'" + other_loop + "' means " + std::to_string(loops.second.size() + named.size()) + " loops, '" + loop +
                        "' " + std::to_string(loops.first.size()),
                    "name as many loops on both garments"});
  return loops;
}

MixLoops mix_loops_in(const EditInput& first, const EditInput& second, const std::string& region) {
  const std::string place = "edit 'mix', region";
  const std::size_t dots = region.find("..");
  if (dots == std::string::npos)
    throw BadInput({"edit.bad-region", Severity::error, place, "'" + region + "' is not two loops",
                    "write two loops or levels with two dots between, such as \"waist..hip\""});
  const auto axes = trunk_and_limbs(first.body.form);
  const auto curves = [&](const std::string& name) {
    std::vector<LimbCurve> found;
    for (const CutLoop& loop : named_loops(first, name, place))
      found.push_back(limb_curve(first.body, axes, points_of(loop, first.drape)));
    return found;
  };
  const std::vector<LimbCurve> from = curves(region.substr(0, dots)), to = curves(region.substr(dots + 2));
  MixLoops loops;
  for (const LimbCurve& begin : from) {
    const auto end = std::find_if(to.begin(), to.end(), [&](const LimbCurve& curve) { return curve.limb == begin.limb; });
    if (end == to.end() || from.size() != to.size())
      throw BadInput({"edit.bad-region", Severity::error, place, "the two ends of the region are not round the same limbs",
                      "name two loops or levels round the same limbs"});
    RegionCut cut = cut_in_region(first, second, begin, *end, place);
    CutLoop own = line_at(first, axes, cut.curve, place), other = line_at(second, axes, cut.curve, place);
    // A cut that touches a seam at the region's end is sought farther inside.
    for (const double inset : {beside_seam, 2 * beside_seam}) {
      if (!sliver(first, own, place) && !sliver(second, other, place)) break;
      LimbCurve from_inside = begin, to_inside = *end;
      for (double& along : from_inside.along) along += inset;
      for (double& along : to_inside.along) along -= inset;
      if (!std::equal(from_inside.along.begin(), from_inside.along.end(), to_inside.along.begin(), std::less<>())) break;
      cut = cut_in_region(first, second, from_inside, to_inside, place);
      own = line_at(first, axes, cut.curve, place);
      other = line_at(second, axes, cut.curve, place);
    }
    loops.first.push_back(std::move(own));
    loops.second.push_back(std::move(other));
    const auto points = points_of(loops.first.back(), first.drape);
    double height = 0;
    for (const Eigen::Vector3d& point : points) height += point.y() / static_cast<double>(points.size());
    loops.report.note("edit.region", place,
                      "cut at " + in_mm(height, 0) + " above the floor in the mean, along " + in_mm(cut.length, 0) +
                          " of edges where the normals of the two garments differ by " + in_degrees(cut.turned) +
                          " degrees in the mean; the shortest cut is " + in_mm(cut.shortest, 0));
  }
  return loops;
}

}  // namespace toile
