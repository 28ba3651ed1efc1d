#include "collide/truncation.h"

#include <algorithm>

namespace toile {
namespace {

constexpr double slack = 0.05;       // of the distance, kept on each side of a plane
constexpr double move_share = 0.45;  // of the reach; below a half, so that two sides that were farther apart cannot meet
constexpr int slides = 4;            // projections onto the planes before the move is shortened instead

}  // namespace

Truncation::Truncation(Eigen::Matrix3Xd positions, const CollisionMesh& mesh, double reach)
    : start_(std::move(positions)), longest_(move_share * reach), pairs_(near_pairs(start_, mesh, reach)) {
  make_planes();
}

Truncation::Truncation(Eigen::Matrix3Xd positions, NearPairSearch& search)
    : start_(std::move(positions)), longest_(move_share * search.distance()), pairs_(search.find(start_)) {
  make_planes();
}

void Truncation::make_planes() {
  begin_.assign(static_cast<std::size_t>(start_.cols()) + 1, 0);
  for (const NearPair& pair : pairs_)
    for (const int v : pair.vertex) ++begin_[static_cast<std::size_t>(v) + 1];
  for (std::size_t v = 1; v < begin_.size(); ++v) begin_[v] += begin_[v - 1];
  planes_.resize(static_cast<std::size_t>(begin_.back()));
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  for (const NearPair& pair : pairs_) {
    const double middle = pair.normal.dot(pair.middle);
    for (int i = 0; i < 4; ++i) {
      const double side = i < pair.first ? 1 : -1;
      const int v = pair.vertex[static_cast<std::size_t>(i)];
      planes_[static_cast<std::size_t>(next[static_cast<std::size_t>(v)]++)] = {side * pair.normal,
                                                                                side * middle + slack * pair.distance};
    }
  }
}

Eigen::Vector3d Truncation::allowed(Eigen::Index v, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
  const auto first = planes_.begin() + begin_[static_cast<std::size_t>(v)];
  const auto last = planes_.begin() + begin_[static_cast<std::size_t>(v) + 1];
  Eigen::Vector3d goal = to;
  if (const Eigen::Vector3d whole = to - start_.col(v); whole.squaredNorm() > longest_ * longest_)
    goal = start_.col(v) + longest_ / whole.norm() * whole;
  bool clear = false;
  for (int slide = 0; slide < slides && !clear; ++slide) {
    clear = true;
    for (auto plane = first; plane != last; ++plane) {
      const double depth = plane->offset - plane->normal.dot(goal);
      if (depth <= 0) continue;
      goal += depth * plane->normal;
      clear = false;
    }
  }
  const Eigen::Vector3d move = goal - from;
  double share = 1;
  for (auto plane = first; plane != last; ++plane) {
    if (plane->normal.isZero()) return from;  // touching: no plane parts them
    const double approach = -plane->normal.dot(move);
    const double room = std::max(0.0, plane->normal.dot(from) - plane->offset);
    if (approach > 0) share = std::min(share, room / approach);
  }
  // Sliding along the planes may leave the ball again.
  const Eigen::Vector3d reached = from + share * move;
  if ((reached - start_.col(v)).squaredNorm() <= longest_ * longest_ * (1 + 1e-12)) return reached;
  const Eigen::Vector3d a = from - start_.col(v);
  const Eigen::Vector3d b = share * move;
  const double half = a.dot(b);
  const double square = b.squaredNorm();
  const double root = std::sqrt(std::max(0.0, half * half + square * (longest_ * longest_ - a.squaredNorm())));
  return from + std::clamp((root - half) / square, 0.0, 1.0) * b;
}

double Truncation::advance(Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) const {
  double behind = 0;
  for (Eigen::Index v = 0; v < from.cols(); ++v) {
    if (from.col(v) == to.col(v)) continue;
    from.col(v) = allowed(v, from.col(v), to.col(v));
    behind = std::max(behind, (from.col(v) - to.col(v)).squaredNorm());
  }
  return std::sqrt(behind);
}

}  // namespace toile
