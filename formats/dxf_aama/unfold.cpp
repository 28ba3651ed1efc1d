#include "formats/dxf_aama/unfold.h"

#include <algorithm>

namespace toile::aama {
namespace {

Eigen::Vector2d onto(const Eigen::Vector2d& at, const Axis& axis) {
  return axis.from + axis.along.dot(at - axis.from) * axis.along;
}

// Rotates a closed half with an edge on the axis so that it starts at the end of that edge and stops at its beginning.
std::optional<Points<2>> open_half(const Points<2>& ring, const Axis& axis) {
  const std::size_t n = ring.size();
  const auto on_axis = [&](std::size_t i) { return distance_to_axis(ring[i % n], axis) <= closing_gap; };
  std::size_t off = 0;
  while (off < n && on_axis(off)) ++off;
  if (off == n) return {};
  std::size_t best_begin = 0, best_count = 0;
  for (std::size_t i = off; i < off + n;) {
    std::size_t count = 0;
    while (count < n && on_axis(i + count)) ++count;
    if (count > best_count) {
      best_begin = i;
      best_count = count;
    }
    i += std::max<std::size_t>(count, 1);
  }
  if (best_count < 2) return {};
  Points<2> half;
  for (std::size_t i = best_begin + best_count - 1; i <= best_begin + n; ++i) half.push_back(ring[i % n]);
  return half;
}

void reflect_all(DrawnPiece& piece, const Axis& axis) {
  const auto apart = [&](const Eigen::Vector2d& at) { return distance_to_axis(at, axis) > closing_gap; };
  const auto double_up = [&](auto& items) {
    const std::size_t count = items.size();
    for (std::size_t i = 0; i < count; ++i) {
      if (!apart(items[i].at)) continue;
      auto other = items[i];
      other.at = reflected(other.at, axis);
      items.push_back(other);
    }
  };
  double_up(piece.points);
  double_up(piece.drill_holes);
  const std::size_t count = piece.notches.size();
  double_up(piece.notches);
  for (std::size_t i = count; i < piece.notches.size(); ++i) {
    Eigen::Vector2d& direction = piece.notches[i].direction;
    direction = reflected(axis.from + direction, axis) - axis.from;
  }
}

}  // namespace

std::optional<Axis> mirror_axis(const DrawnPiece& piece) {
  std::optional<Axis> axis;
  double longest = closing_gap;
  for (const Run& run : piece.mirror) {
    if (run.points.size() < 2) continue;
    const Eigen::Vector2d d = run.points.back() - run.points.front();
    if (d.norm() <= longest) continue;
    longest = d.norm();
    axis = Axis{run.points.front(), d.normalized()};
  }
  return axis;
}

Eigen::Vector2d reflected(const Eigen::Vector2d& at, const Axis& axis) { return 2 * onto(at, axis) - at; }

double distance_to_axis(const Eigen::Vector2d& at, const Axis& axis) { return (at - onto(at, axis)).norm(); }

std::optional<Points<2>> unfolded(const Chain& chain, const Axis& axis) {
  Points<2> half = chain.points;
  if (chain.closed) {
    std::optional<Points<2>> opened = open_half(half, axis);
    if (!opened) return {};
    half = std::move(*opened);
  }
  if (half.size() < 3 || distance_to_axis(half.front(), axis) > closing_gap ||
      distance_to_axis(half.back(), axis) > closing_gap)
    return {};
  half.front() = onto(half.front(), axis);
  half.back() = onto(half.back(), axis);
  Points<2> ring = half;
  for (std::size_t i = half.size() - 1; i-- > 1;) ring.push_back(reflected(half[i], axis));
  // Begin where the file does, if that vertex is still there.
  const auto first = std::find_if(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(half.size()),
                                  [&](const Eigen::Vector2d& p) { return (p - chain.points.front()).norm() <= closing_gap; });
  if (first != ring.begin() + static_cast<std::ptrdiff_t>(half.size())) std::rotate(ring.begin(), first, ring.end());
  return ring;
}

void unfold_details(DrawnPiece& piece, const Axis& axis) {
  reflect_all(piece, axis);
  for (std::vector<Run>* runs : {&piece.internal_lines, &piece.cut_outs}) {
    const std::size_t count = runs->size();
    for (std::size_t i = 0; i < count; ++i) {
      Run other = (*runs)[i];
      if (other.points.empty()) continue;
      const bool as_drawn =
          std::any_of(piece.not_mirrored.begin(), piece.not_mirrored.end(),
                      [&](const Eigen::Vector2d& label) { return (label - other.points.front()).norm() <= piece.tolerance; });
      const bool on_axis = std::all_of(other.points.begin(), other.points.end(),
                                       [&](const Eigen::Vector2d& p) { return distance_to_axis(p, axis) <= closing_gap; });
      if (as_drawn || on_axis) continue;
      for (Eigen::Vector2d& p : other.points) p = reflected(p, axis);
      runs->push_back(std::move(other));
    }
  }
}

}  // namespace toile::aama
