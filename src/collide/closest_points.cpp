#include "collide/closest_points.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace toile {
namespace {

double along(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double square = (b - a).squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(b - a) / square, 0.0, 1.0) : 0;
}

}  // namespace

ClosestPoints closest_to_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                  const Eigen::Vector3d& c) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  const double square = normal.squaredNorm();
  Eigen::Vector3d w(-1, 0, 0);
  if (square > 0) {
    w.x() = (c - b).cross(p - b).dot(normal) / square;
    w.y() = (a - c).cross(p - c).dot(normal) / square;
    w.z() = 1 - w.x() - w.y();
  }
  if (w.minCoeff() < 0) {
    double nearest = std::numeric_limits<double>::infinity();
    const std::array<const Eigen::Vector3d*, 3> corner{&a, &b, &c};
    Eigen::Vector3d on_edge = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const Eigen::Vector3d& from = *corner[static_cast<std::size_t>(i)];
      const Eigen::Vector3d& to = *corner[static_cast<std::size_t>(j)];
      const double t = along(p, from, to);
      const double apart = (p - from - t * (to - from)).squaredNorm();
      if (apart >= nearest) continue;
      nearest = apart;
      on_edge.setZero();
      on_edge(i) = 1 - t;
      on_edge(j) = t;
    }
    w = on_edge;
  }
  ClosestPoints closest;
  closest.weight << 1, w;
  closest.apart = p - (w.x() * a + w.y() * b + w.z() * c);
  closest.distance = closest.apart.norm();
  return closest;
}

ClosestPoints closest_of_segments(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                                  const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a;
  const Eigen::Vector3d v = d - c;
  const double uu = u.squaredNorm();
  const double vv = v.squaredNorm();
  const double uv = u.dot(v);
  const double spread = uu * vv - uv * uv;
  double s = 0;
  if (spread > 1e-14 * uu * vv) s = std::clamp((uv * v.dot(a - c) - vv * u.dot(a - c)) / spread, 0.0, 1.0);
  const double t = along(a + s * u, c, d);
  s = along(c + t * v, a, b);
  ClosestPoints closest;
  closest.weight << 1 - s, s, 1 - t, t;
  closest.apart = a + s * u - c - t * v;
  closest.distance = closest.apart.norm();
  return closest;
}

}  // namespace toile
