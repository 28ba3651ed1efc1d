#include "edit/fit/room.h"

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

#include "body/girth.h"
#include "edit/loops.h"

namespace toile {
namespace {

using Corners = std::vector<Eigen::Vector2d>;

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

// Counter-clockwise (Andrew's monotone chain).
Corners convex_hull(Corners points) {
  std::sort(points.begin(), points.end(), [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Corners hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

// Negative inside.
double distance_to_hull(const Corners& hull, const Eigen::Vector2d& at) {
  double inside = -std::numeric_limits<double>::infinity(), nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d a = hull[i], along = hull[(i + 1) % hull.size()] - a;
    inside = std::max(inside, -turn(a, a + along, at) / along.norm());
    const double share = std::clamp((at - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (a + share * along - at).norm());
  }
  return inside <= 0 ? inside : nearest;
}

// The tape round both legs, in the plane of the loop.
struct Tape {
  Eigen::Vector3d centre, x, y;
  Corners hull;
  double distance(const Eigen::Vector3d& at) const { return distance_to_hull(hull, {x.dot(at - centre), y.dot(at - centre)}); }
};

std::optional<Tape> tape_round_parts(const Body& body, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                                     const Eigen::Vector3d& axis) {
  Tape tape;
  tape.centre = loop_centre(positions, loop);
  tape.x = axis.unitOrthogonal();
  tape.y = axis.cross(tape.x);
  Corners points;
  int parts = 0;
  for (const SectionLoop& part : section_loops(body.form.positions, body.form.triangles, tape.centre, axis)) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& at : part) middle += at / static_cast<double>(part.size());
    if (crossings(positions, loop, middle - 0.05 * axis, middle + 0.05 * axis) == 0) continue;
    ++parts;
    for (const Eigen::Vector3d& at : part) points.emplace_back(tape.x.dot(at - tape.centre), tape.y.dot(at - tape.centre));
  }
  if (parts < 2) return std::nullopt;
  tape.hull = convex_hull(std::move(points));
  return tape;
}

}  // namespace

Eigen::VectorXd room_inwards(const Body& body, const Eigen::Matrix3Xd& positions, const VertexLoop& loop,
                             const Eigen::Vector3d& axis, const Eigen::Matrix3Xd& outward, const Eigen::VectorXd& reach,
                             const Eigen::VectorXd& least) {
  constexpr double nearest_step = 0.1e-3;
  const auto tape = tape_round_parts(body, positions, loop, axis);
  Eigen::VectorXd room(static_cast<Eigen::Index>(loop.size()));
  for (Eigen::Index i = 0; i < room.size(); ++i) {
    const int v = loop[static_cast<std::size_t>(i)];
    const Eigen::Vector3d from = positions.col(v);
    const double most = 0.75 * reach(i);
    double gone = 0;
    while (gone < most) {
      const Eigen::Vector3d at = from - gone * outward.col(i);
      double left = body.distance.distance(at);
      if (tape) left = std::min(left, tape->distance(at));
      left -= least(v);
      if (left <= nearest_step) break;
      gone += left;
    }
    room(i) = std::min(gone, most);
  }
  return room;
}

}  // namespace toile
