#include "body/parametric_rays.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

Chain turned(const BodyForm& form, const Eigen::Vector3d& centre, const Eigen::Vector3d& first, const Eigen::Vector3d& along,
             double turn, int steps, int count) {
  const Eigen::Vector3d start = (first - first.dot(along) * along).normalized(), aside = along.cross(start);
  Chain chain;
  for (int i = 0; i < count; ++i) {
    const double angle = turn * i / steps;
    const Eigen::Vector3d direction = std::cos(angle) * start + std::sin(angle) * aside;
    double limit = .6;
    if (centre.x() > 1e-6 && direction.x() < 0) limit = std::min(limit, -centre.x() / direction.x());
    chain.push_back(way_out(form, centre, direction, limit));
  }
  return chain;
}

}  // namespace

Eigen::Vector3d way_out(const BodyForm& form, const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double limit) {
  double inside = 0, inside_distance = form.distance(from), outside = limit, outside_distance = 0;
  for (double t = 0, d = inside_distance; t < limit;) {
    t = std::min(t + std::clamp(-.8 * d, .002, .02), limit);
    d = form.distance(from + t * direction);
    if (d > 0) {
      outside = t, outside_distance = d;
      break;
    }
    inside = t, inside_distance = d;
  }
  if (outside_distance == 0) return from + limit * direction;
  for (int i = 0; i < 6 && outside - inside > 1e-6; ++i) {
    const double share = std::clamp(inside_distance / (inside_distance - outside_distance), .05, .95);
    const double t = inside + share * (outside - inside);
    const double d = form.distance(from + t * direction);
    if (d > 0)
      outside = t, outside_distance = d;
    else
      inside = t, inside_distance = d;
  }
  const double share = inside_distance / (inside_distance - outside_distance);
  return from + (inside + share * (outside - inside)) * direction;
}

Chain ring(const BodyForm& form, const Eigen::Vector3d& centre, const Eigen::Vector3d& first, const Eigen::Vector3d& along,
           int count) {
  return turned(form, centre, first, along, 2 * std::numbers::pi, count, count);
}

Chain half_ring(const BodyForm& form, const Eigen::Vector3d& centre, const Eigen::Vector3d& first, const Eigen::Vector3d& along,
                int count) {
  Chain chain = turned(form, centre, first, along, std::numbers::pi, count - 1, count);
  chain.front().x() = 0, chain.back().x() = 0;
  return chain;
}

double length(const Chain& chain) {
  double sum = 0;
  for (std::size_t i = 1; i < chain.size(); ++i) sum += (chain[i] - chain[i - 1]).norm();
  return sum;
}

Chain at_shares(const Chain& chain, const std::vector<double>& shares) {
  const double whole = length(chain);
  Chain points;
  std::size_t i = 1;
  double walked = 0;
  for (const double share : shares) {
    double piece = (chain[i] - chain[i - 1]).norm();
    while (i + 1 < chain.size() && walked + piece < share * whole) {
      walked += piece;
      ++i;
      piece = (chain[i] - chain[i - 1]).norm();
    }
    const double t = piece > 0 ? std::clamp((share * whole - walked) / piece, 0.0, 1.0) : 0;
    points.push_back(chain[i - 1] + t * (chain[i] - chain[i - 1]));
  }
  return points;
}

Chain resampled(const Chain& chain, int count) {
  std::vector<double> shares;
  for (int i = 0; i < count; ++i) shares.push_back(static_cast<double>(i) / (count - 1));
  Chain points = at_shares(chain, shares);
  points.front() = chain.front(), points.back() = chain.back();
  return points;
}

Chain resampled_ring(Chain chain, int count) {
  chain.push_back(chain.front());
  chain = resampled(chain, count + 1);
  chain.pop_back();
  return chain;
}

}  // namespace toile
