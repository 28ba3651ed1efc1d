#include "body/relative.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "body/coherent_limbs.h"

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

struct Judged {
  RelativePlace place;
  double cost = 0;
};

Judged judge(const Body& body, const LimbAxis& axis, int limb, const Vec& at) {
  const AxisPoint base = axis.by_level ? at_level(axis, at) : nearest_on(axis, at);
  Judged result;
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

  const bool inside = body.distance.distance(at) < 0;
  const Ray ray{body, base.at, place.outward,
                body.skin.crossings(base.at, place.outward, inside ? reach + 10 : reach + skin_slack)};
  if (const auto skin = inside ? ray.way_out(reach) : ray.last_skin()) {
    place.on_skin = base.at + *skin * place.outward;
    place.offset = reach - *skin;
  } else {
    const NearestPoint nearest = body.skin.nearest(at);
    place.on_skin = nearest.at;
    place.offset = inside ? -nearest.distance : nearest.distance;
    place.through_skin = false;
  }
  const double air = inside ? std::abs(place.offset) : ray.air(reach);
  result.cost = air + std::abs(place.beyond) + bone_share * reach + std::max(0.0, base.along - axis.body_end);
  return result;
}

}  // namespace

RelativePlace relative_place(const Body& body, const LimbAxis& axis, int limb, const Vec& at) {
  if (axis.points.size() < 2) throw std::invalid_argument("relative_place: the axis has fewer than two points");
  return judge(body, axis, limb, at).place;
}

RelativePlace relative_place(const Body& body, const Vec& at) {
  const std::vector<LimbAxis> axes = limb_axes(body.form);
  Judged best;
  for (std::size_t limb = 0; limb < axes.size(); ++limb)
    if (const Judged judged = judge(body, axes[limb], static_cast<int>(limb), at); limb == 0 || judged.cost < best.cost)
      best = judged;
  return best.place;
}

std::vector<RelativePlace> relative_places(const Body& body, const Eigen::Matrix3Xd& positions,
                                           const Eigen::Matrix3Xi& triangles) {
  const std::vector<LimbAxis> axes = limb_axes(body.form);
  Eigen::MatrixXd cost(static_cast<Eigen::Index>(axes.size()), positions.cols());
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    for (Eigen::Index limb = 0; limb < cost.rows(); ++limb)
      cost(limb, v) = judge(body, axes[static_cast<std::size_t>(limb)], static_cast<int>(limb), positions.col(v)).cost;
  const std::vector<int> limbs = coherent_limbs(body.form, axes, cost, positions, triangles);
  std::vector<RelativePlace> places;
  places.reserve(limbs.size());
  for (std::size_t v = 0; v < limbs.size(); ++v)
    places.push_back(
        relative_place(body, axes[static_cast<std::size_t>(limbs[v])], limbs[v], positions.col(static_cast<Eigen::Index>(v))));
  return places;
}

}  // namespace toile
