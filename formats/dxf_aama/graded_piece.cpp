#include "formats/dxf_aama/graded_piece.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/chains.h"

namespace toile::aama {
namespace {

using Eigen::Vector2d;

constexpr double on_line = 1e-3;  // m, farther away nothing belongs to a line

// Where a point of the sample size is bound to.
struct Hold {
  const GradedLine* line = nullptr;
  std::size_t segment = 0;
  double t = 0, distance = INFINITY;
  bool mirrored = false;
};

class Grader {
 public:
  Grader(const Piece& piece, const std::optional<Axis>& fold, const GradedLines& graded)
      : fold_(graded.mirror >= 0 ? fold : std::nullopt), graded_(graded) {
    for (const Edge& edge : piece.outline)
      for (std::size_t i = 0; i + 1 < edge.points.size(); ++i) ring_.push_back(edge.points[i].at);
    for (const Vector2d& p : ring_) ring_holds_.push_back(hold(p, graded_.lines));
  }

  Points<2> ring_in(std::size_t size) const {
    Points<2> ring;
    for (std::size_t i = 0; i < ring_.size(); ++i) ring.push_back(moved(ring_[i], ring_holds_[i], size));
    return ring;
  }

  // Bound to the nearest of `lines`, on the drawn half or beyond the fold.
  Hold hold(const Vector2d& at, const std::vector<GradedLine>& lines) const {
    Hold best;
    for (const bool mirrored : {false, true}) {
      if (mirrored && !fold_) continue;
      const Vector2d p = mirrored ? reflected(at, *fold_) : at;
      for (const GradedLine& line : lines)
        for (std::size_t i = 0; i < line.points.size(); ++i) {
          if (i + 1 == line.points.size() && i > 0) break;
          const Vector2d a = line.points[i];
          const Vector2d ab = i + 1 < line.points.size() ? Vector2d(line.points[i + 1] - a) : Vector2d(0, 0);
          const double t = ab.squaredNorm() > 0 ? std::clamp((p - a).dot(ab) / ab.squaredNorm(), 0.0, 1.0) : 0.0;
          const double distance = (a + t * ab - p).norm();
          if (distance < best.distance - 1e-7) best = {&line, i, t, distance, mirrored};
        }
    }
    return best;
  }

  // `at` in a size, as far from its line as in the sample size.
  Vector2d moved(const Vector2d& at, const Hold& hold, std::size_t size) const {
    if (!hold.line) return at;
    const Points<2>&from = hold.line->points, &to = hold.line->in_size[size];
    Vector2d move = to[hold.segment] - from[hold.segment];
    if (hold.t > 0) move = (1 - hold.t) * move + hold.t * (to[hold.segment + 1] - from[hold.segment + 1]);
    if (!fold_) return at + move;
    const Axis axis = fold_in(size);
    if (distance_to_axis(at, *fold_) <= same_vertex) {
      const Vector2d p = at + move;
      return axis.from + axis.along.dot(p - axis.from) * axis.along;
    }
    return hold.mirrored ? reflected(reflected(at, *fold_) + move, axis) : Vector2d(at + move);
  }

  // Anything else of the piece.
  Vector2d placed(const Vector2d& at, const Points<2>& ring, std::size_t size) const {
    const Hold on = hold(at, graded_.lines);
    return on.distance <= on_line ? moved(at, on, size) : with_outline(at, ring);
  }

  const GradedLines& graded() const { return graded_; }

 private:
  Axis fold_in(std::size_t size) const {
    const Points<2>& line = graded_.lines[static_cast<std::size_t>(graded_.mirror)].in_size[size];
    const Vector2d along = line.back() - line.front();
    return along.norm() > same_vertex ? Axis{line.front(), along.normalized()} : *fold_;
  }

  Vector2d with_outline(const Vector2d& at, const Points<2>& ring) const {
    const std::size_t n = ring_.size();
    Vector2d sum = Vector2d::Zero();
    double weights = 0, last = half_tangent(ring_[n - 1] - at, ring_[0] - at);
    for (std::size_t i = 0; i < n; ++i) {
      const double next = half_tangent(ring_[i] - at, ring_[(i + 1) % n] - at);
      const double weight = (last + next) / (ring_[i] - at).norm();
      sum += weight * (ring[i] - ring_[i]);
      weights += weight;
      last = next;
    }
    return std::isfinite(weights) && std::abs(weights) > 1e-12 ? Vector2d(at + sum / weights) : at;
  }

  static double half_tangent(const Vector2d& a, const Vector2d& b) {
    const double cross = a.x() * b.y() - a.y() * b.x();
    return std::tan(std::atan2(cross, a.dot(b)) / 2);
  }

  std::optional<Axis> fold_;
  const GradedLines& graded_;
  Points<2> ring_;  // of the sample size
  std::vector<Hold> ring_holds_;
};

Points<2> points_of(const Edge& edge) {
  Points<2> points;
  for (const OutlinePoint& point : edge.points) points.push_back(point.at);
  return points;
}

// The same place between the same two points.
double kept_place(const Points<2>& from, const Points<2>& to, double at) {
  const double length = polyline_length<2>(from), graded_length = polyline_length<2>(to);
  if (!(graded_length > 0)) return at;
  double left = at * length, run = 0;
  for (std::size_t i = 1; i < from.size(); ++i) {
    const double step = (from[i] - from[i - 1]).norm(), graded_step = (to[i] - to[i - 1]).norm();
    if (left <= step || i + 1 == from.size())
      return std::clamp((run + (step > 0 ? std::min(left / step, 1.0) : 0.0) * graded_step) / graded_length, 0.0, 1.0);
    left -= step;
    run += graded_step;
  }
  return at;
}

Piece in_size(const Piece& piece, const Grader& grader, std::size_t size) {
  Piece graded = piece;
  const Points<2> ring = grader.ring_in(size);
  std::size_t next = 0;
  for (Edge& edge : graded.outline) {
    for (std::size_t i = 0; i < edge.points.size(); ++i) edge.points[i].at = ring[(next + i) % ring.size()];
    next += edge.points.size() - 1;
  }
  for (std::size_t i = 0; i < piece.notches.size(); ++i) {
    const Notch& notch = piece.notches[i];
    const Edge* edge = find_edge(piece, notch.edge);
    const Points<2> from = points_of(*edge), to = points_of(*find_edge(graded, notch.edge));
    const Vector2d at = point_at<2>(from, notch.at);
    // One with moves of its own goes to the nearest place of its edge.
    const Hold own = grader.hold(at, grader.graded().notches);
    constexpr double widest_hem = 60e-3;  // m, a notch on the cut line
    if (own.distance > widest_hem || notch.at == 0)
      graded.notches[i].at = kept_place(from, to, notch.at);
    else
      graded.notches[i].at = nearest_on<2>(to, grader.moved(at, own, size)).at;
  }
  for (InternalLine& line : graded.internal_lines)
    for (Vector2d& p : line.points) p = grader.placed(p, ring, size);
  for (DrillHole& hole : graded.drill_holes) {
    const Hold own = grader.hold(hole.at, grader.graded().drills);
    hole.at = own.distance <= on_line ? grader.moved(hole.at, own, size) : grader.placed(hole.at, ring, size);
  }
  if (graded.grainline) {
    graded.grainline->from = grader.placed(graded.grainline->from, ring, size);
    graded.grainline->to = grader.placed(graded.grainline->to, ring, size);
    if ((graded.grainline->to - graded.grainline->from).norm() < 1e-4) graded.grainline = piece.grainline;
  }
  return graded;
}

}  // namespace

std::vector<Piece> graded_pieces(const Piece& piece, const std::optional<Axis>& fold, const GradedLines& graded,
                                 std::size_t sizes) {
  if (graded.lines.empty()) return std::vector<Piece>(sizes, piece);
  const Grader grader(piece, fold, graded);
  std::vector<Piece> pieces;
  for (std::size_t size = 0; size < sizes; ++size) pieces.push_back(in_size(piece, grader, size));
  return pieces;
}

}  // namespace toile::aama
