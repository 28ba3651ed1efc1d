#include "body/relative.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "body/coherent_limbs.h"
#include "parallel/threads.h"

namespace toile {
namespace {

using Vec = Eigen::Vector3d;

constexpr double skin_slack = 2e-3;  // m, by which distance field and triangles may disagree on the side of a point
constexpr double bone_share = .25;

struct AxisPoint {
  Vec at, direction;
  double along = 0;
};

AxisPoint at_level(const LimbAxis& axis, const Vec& query) {
  double along = 0;
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const Vec &from = axis.points[i - 1], &to = axis.points[i];
    const double t = std::clamp((from[1] - query[1]) / (from[1] - to[1]), 0.0, 1.0), length = (to - from).norm();
    if (t < 1 || i + 1 == axis.points.size()) return {from + t * (to - from), -Vec::UnitY(), along + t * length};
    along += length;
  }
  throw std::invalid_argument("relative_place: the axis has fewer than two points");
}

AxisPoint nearest_on(const LimbAxis& axis, const Vec& query) {
  AxisPoint best;
  double least = std::numeric_limits<double>::infinity(), before = 0;
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const Vec& from = axis.points[i - 1];
    const Vec span = axis.points[i] - from;
    const double length = span.norm(), t = std::clamp((query - from).dot(span) / (length * length), 0.0, 1.0);
    const Vec at = from + t * span;
    if (const double distance = (query - at).norm(); distance < least) {
      least = distance;
      best = {at, span / length, before + t * length};
      // On the outer side of a bend the direction turns with the point, so that it stays square to v - p_b.
      if (t == 1 && i + 1 < axis.points.size() && distance > 0) {
        const Vec out = (query - at) / distance, mean = best.direction + (axis.points[i + 1] - at).normalized();
        if (const Vec square = mean - mean.dot(out) * out; square.norm() > 1e-6) best.direction = square.normalized();
      }
    }
    before += length;
  }
  return best;
}

// From the bone outwards; `crossings` sorted, m. Walls inside the body, where its parts overlap, are passed over.
struct Ray {
  const Body& body;
  Vec from, direction;
  std::vector<double> crossings;

  bool outside_between(double a, double b) const {
    return b - a > 1e-9 && body.distance.distance(from + (a + b) / 2 * direction) > 0;
  }

  std::optional<double> last_skin() const { return crossings.empty() ? std::nullopt : std::optional(crossings.back()); }

  std::optional<double> way_out(double start) const {
    for (std::size_t i = 0; i < crossings.size(); ++i)
      if (crossings[i] >= start - skin_slack && (i + 1 == crossings.size() || outside_between(crossings[i], crossings[i + 1])))
        return crossings[i];
    return std::nullopt;
  }

  // Length outside the body between the bone and `end`.
  double air(double end) const {
    double sum = 0, before = 0;
    const auto add = [&](double until) {
      if (outside_between(before, until)) sum += until - before;
      before = until;
    };
    for (const double t : crossings) add(std::min(t, end));
    add(end);
    return sum;
  }
};

// The axial part of a place, and what it costs without the air.
struct Axial {
  RelativePlace place;
  double cost = 0;
};

Axial axial(const LimbAxis& axis, int limb, const Vec& at) {
  const AxisPoint base = axis.by_level ? at_level(axis, at) : nearest_on(axis, at);
  Axial result;
  RelativePlace& place = result.place;
  place.limb = limb;
  place.along = base.along;
  place.on_axis = base.at;
  place.axis = base.direction;
  const Vec arm = at - base.at;
  const double reach = arm.norm();
  place.beyond = place.axis.dot(arm);
  if (reach > 1e-9) {
    place.outward = arm / reach;
  } else {
    const Vec forward = Vec::UnitZ() - place.axis[2] * place.axis;
    place.outward = forward.norm() > 1e-3 ? forward.normalized() : Vec(Vec::UnitX());
  }
  result.cost = std::abs(place.beyond) + bone_share * reach + std::max(0.0, base.along - axis.body_end);
  return result;
}

// Finds the skin for `place`; returns the air between bone and point, m.
double find_skin(const Body& body, const Vec& at, RelativePlace& place) {
  const double reach = (at - place.on_axis).norm();
  const bool inside = body.distance.distance(at) < 0;
  const Ray ray{body, place.on_axis, place.outward,
                body.skin.crossings(place.on_axis, place.outward, inside ? reach + 10 : reach + skin_slack)};
  if (const auto skin = inside ? ray.way_out(reach) : ray.last_skin()) {
    place.on_skin = place.on_axis + *skin * place.outward;
    place.offset = reach - *skin;
  } else {
    const NearestPoint nearest = body.skin.nearest(at);
    place.on_skin = nearest.at;
    place.offset = inside ? -nearest.distance : nearest.distance;
    place.through_skin = false;
  }
  return inside ? std::abs(place.offset) : ray.air(reach);
}

struct Judged {
  std::vector<double> cost;  // by limb; of limbs that are dearer than the best by more than `slack` at least that much
  RelativePlace best;
};

Judged judge(const Body& body, const std::vector<LimbAxis>& axes, const Vec& at, double slack) {
  std::vector<Axial> found;
  for (std::size_t limb = 0; limb < axes.size(); ++limb) found.push_back(axial(axes[limb], static_cast<int>(limb), at));
  std::stable_sort(found.begin(), found.end(), [](const Axial& a, const Axial& b) { return a.cost < b.cost; });
  Judged result;
  result.cost.resize(axes.size());
  double least = std::numeric_limits<double>::infinity();
  for (Axial& one : found) {
    if (one.cost <= least + slack) one.cost += find_skin(body, at, one.place);
    result.cost[static_cast<std::size_t>(one.place.limb)] = one.cost;
    if (one.cost < least) {
      least = one.cost;
      result.best = one.place;
    }
  }
  return result;
}

}  // namespace

RelativePlace relative_place(const Body& body, const LimbAxis& axis, int limb, const Vec& at) {
  if (axis.points.size() < 2) throw std::invalid_argument("relative_place: the axis has fewer than two points");
  RelativePlace place = axial(axis, limb, at).place;
  find_skin(body, at, place);
  return place;
}

RelativePlace relative_place(const Body& body, const Vec& at) { return judge(body, limb_axes(body.form), at, 0).best; }

std::vector<RelativePlace> relative_places(const Body& body, const Eigen::Matrix3Xd& positions,
                                           const Eigen::Matrix3Xi& triangles) {
  if (triangles.size() > 0 && (triangles.minCoeff() < 0 || triangles.maxCoeff() >= positions.cols()))
    throw std::invalid_argument("relative_places: a triangle names a vertex that is not there");
  const std::vector<LimbAxis> axes = limb_axes(body.form);
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(axes.size()), positions.cols());
  std::vector<RelativePlace> places(static_cast<std::size_t>(positions.cols()));
  in_ranges(16, static_cast<int>(positions.cols()), [&](int, int begin, int end) {
    for (int v = begin; v < end; ++v) {
      const Judged judged = judge(body, axes, positions.col(v), limb_disagreement);
      cost.col(v) = Eigen::Map<const Eigen::VectorXd>(judged.cost.data(), cost.rows());
      places[static_cast<std::size_t>(v)] = judged.best;
    }
  });
  const std::vector<int> limbs = coherent_limbs(body.form, axes, cost, positions, triangles);
  for (std::size_t v = 0; v < limbs.size(); ++v)
    if (limbs[v] != places[v].limb)
      places[v] =
          relative_place(body, axes[static_cast<std::size_t>(limbs[v])], limbs[v], positions.col(static_cast<Eigen::Index>(v)));
  return places;
}

}  // namespace toile
