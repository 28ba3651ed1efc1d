#include "edit/mix/limb_curve.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace toile {
namespace {

constexpr int steps_round = 360;
constexpr double turn = 2 * std::numbers::pi;

int step_of(double angle) {
  const int step = static_cast<int>(std::floor(angle / turn * steps_round + 0.5)) % steps_round;
  return step < 0 ? step + steps_round : step;
}

double distance_to(const LimbAxis& axis, const Eigen::Vector3d& at) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < axis.points.size(); ++i) {
    const Eigen::Vector3d way = axis.points[i] - axis.points[i - 1];
    const double t = std::clamp((at - axis.points[i - 1]).dot(way) / std::max(1e-12, way.squaredNorm()), 0.0, 1.0);
    best = std::min(best, (axis.points[i - 1] + t * way - at).norm());
  }
  return best;
}

// Steps without a value, between those that have one.
void bridge(std::vector<double>& along, const std::vector<double>& weight) {
  const auto n = along.size();
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < n; ++i)
    if (weight[i] > 0) known.push_back(i);
  for (std::size_t k = 0; k < known.size(); ++k) {
    const std::size_t from = known[k], to = known[(k + 1) % known.size()] + (k + 1 == known.size() ? n : 0);
    for (std::size_t i = from + 1; i < to; ++i) {
      const double t = static_cast<double>(i - from) / static_cast<double>(to - from);
      along[i % n] = (1 - t) * along[from] + t * along[to % n];
    }
  }
}

}  // namespace

std::vector<LimbAxis> trunk_and_limbs(const Mannequin& form) {
  std::vector<LimbAxis> axes = limb_axes(form);
  if (axes.front().by_level) return axes;
  Mannequin bare = form;
  bare.bones.clear();
  axes.front() = limb_axes(bare).front();
  return axes;
}

LimbPlace limb_place(const Body& body, const LimbAxis& axis, int limb, const Eigen::Vector3d& at) {
  const RelativePlace place = relative_place(body, axis, limb, at);
  Eigen::Vector3d front = Eigen::Vector3d::UnitZ() - place.axis.z() * place.axis;
  if (front.norm() < 1e-3) front = Eigen::Vector3d::UnitY() - place.axis.y() * place.axis;
  front.normalize();
  return {place.along + place.beyond, std::atan2(front.cross(place.axis).dot(place.outward), front.dot(place.outward))};
}

int limb_inside(const Body& body, const std::vector<LimbAxis>& axes, const std::vector<Eigen::Vector3d>& line) {
  Eigen::Matrix3Xd at(3, static_cast<Eigen::Index>(line.size()));
  VertexLoop loop(line.size());
  std::iota(loop.begin(), loop.end(), 0);
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < line.size(); ++i) {
    at.col(static_cast<Eigen::Index>(i)) = line[i];
    centre += line[i] / static_cast<double>(line.size());
  }
  const Threading through = threading(skeleton_chains(body.form), at, loop);
  if (through.heads > 0 || through.feet + through.hands != 1) return 0;
  int best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < axes.size(); ++i) {
    const double distance = distance_to(axes[i], centre);
    if (distance < nearest) {
      nearest = distance;
      best = static_cast<int>(i);
    }
  }
  return best;
}

LimbCurve limb_curve(const Body& body, const std::vector<LimbAxis>& axes, const std::vector<Eigen::Vector3d>& line) {
  constexpr double step = 2e-3;  // m
  LimbCurve curve{limb_inside(body, axes, line), std::vector<double>(steps_round, 0)};
  std::vector<double> weight(steps_round, 0);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Eigen::Vector3d a = line[i], b = line[(i + 1) % line.size()];
    const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / step)));
    for (int k = 0; k < parts; ++k) {
      const LimbPlace place =
          limb_place(body, axes[static_cast<std::size_t>(curve.limb)], curve.limb, a + (b - a) * ((k + 0.5) / parts));
      const auto at = static_cast<std::size_t>(step_of(place.angle));
      const double share = (b - a).norm() / parts;
      curve.along[at] += share * place.along;
      weight[at] += share;
    }
  }
  for (std::size_t i = 0; i < weight.size(); ++i)
    if (weight[i] > 0) curve.along[i] /= weight[i];
  bridge(curve.along, weight);
  return curve;
}

double along_at(const LimbCurve& curve, double angle) {
  const auto n = static_cast<double>(curve.along.size());
  double at = std::fmod(angle / turn * n, n);
  if (at < 0) at += n;
  const double whole = std::floor(at);
  const auto i = static_cast<std::size_t>(whole) % curve.along.size();
  return (1 - (at - whole)) * curve.along[i] + (at - whole) * curve.along[(i + 1) % curve.along.size()];
}

LimbCurve smoothed(const LimbCurve& curve, int waves) {
  const auto n = static_cast<double>(curve.along.size());
  LimbCurve smooth{curve.limb, std::vector<double>(curve.along.size(), 0)};
  for (int k = 0; k <= waves; ++k) {
    double cosine = 0, sine = 0;
    for (std::size_t i = 0; i < curve.along.size(); ++i) {
      cosine += curve.along[i] * std::cos(turn * k * static_cast<double>(i) / n) * (k == 0 ? 1 : 2) / n;
      sine += curve.along[i] * std::sin(turn * k * static_cast<double>(i) / n) * (k == 0 ? 1 : 2) / n;
    }
    for (std::size_t i = 0; i < smooth.along.size(); ++i)
      smooth.along[i] +=
          cosine * std::cos(turn * k * static_cast<double>(i) / n) + sine * std::sin(turn * k * static_cast<double>(i) / n);
  }
  return smooth;
}

Eigen::VectorXd beyond(const Body& body, const std::vector<LimbAxis>& axes, const LimbCurve& curve,
                       const Eigen::Matrix3Xd& positions) {
  Eigen::VectorXd far(positions.cols());
  for (Eigen::Index v = 0; v < positions.cols(); ++v) {
    const LimbPlace place = limb_place(body, axes[static_cast<std::size_t>(curve.limb)], curve.limb, positions.col(v));
    far(v) = place.along - along_at(curve, place.angle);
  }
  return far;
}

}  // namespace toile
