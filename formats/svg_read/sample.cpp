#include <algorithm>
#include <cmath>

#include "formats/svg_read/path.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

constexpr double corner_angle = 10 * units::degree;
constexpr double no_length = 1e-6;     // m
constexpr double straight = 5e-6;      // m, a curve this near to its chord is one
constexpr double on_the_line = 1e-5;   // m, a vertex that does not bend the line
constexpr double short_handle = 2e-4;  // m, too short to tell a direction
constexpr double meeting = 5e-5;       // m, ends of one path that are one point

double off_chord(const Vector2d& p, const Vector2d& a, const Vector2d& b) { return nearest_on<2>({a, b}, p).distance; }

Vector2d tangent(std::initializer_list<Vector2d> points) {
  const Vector2d from = *points.begin();
  Vector2d way = Vector2d::Zero();
  for (const Vector2d& p : points) {
    way = p - from;
    if (way.norm() > short_handle) break;
  }
  return way;
}

Vector2d way_out(const Segment& s) { return s.curve ? tangent({s.from, s.c1, s.c2, s.to}) : Vector2d(s.to - s.from); }
Vector2d way_in(const Segment& s) { return s.curve ? Vector2d(-tangent({s.to, s.c2, s.c1, s.from})) : Vector2d(s.to - s.from); }

double angle_between(const Vector2d& a, const Vector2d& b) {
  return std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
}

std::vector<Segment> in_metres(const SubPath& part, const Affine& to_metres) {
  std::vector<Segment> segments;
  for (Segment s : part.segments) {
    for (Vector2d* p : {&s.from, &s.c1, &s.c2, &s.to}) *p = to_metres * *p;
    const double size =
        std::max({(s.to - s.from).norm(), s.curve ? (s.c1 - s.from).norm() : 0.0, s.curve ? (s.c2 - s.to).norm() : 0.0});
    if (size < no_length) continue;
    if (s.curve && off_chord(s.c1, s.from, s.to) <= straight && off_chord(s.c2, s.from, s.to) <= straight) s.curve = false;
    if (!segments.empty()) s.from = segments.back().to;
    segments.push_back(s);
  }
  return segments;
}

Points<2> curve_points(const Segment& s, double tolerance) {
  const auto at = [&](double t) -> Vector2d {
    const double u = 1 - t;
    return u * u * u * s.from + 3 * u * u * t * s.c1 + 3 * u * t * t * s.c2 + t * t * t * s.to;
  };
  const double bend = std::max((s.from - 2 * s.c1 + s.c2).norm(), (s.c1 - 2 * s.c2 + s.to).norm());
  const int least = std::clamp(static_cast<int>(std::ceil(std::sqrt(.75 * bend / (tolerance / 8)))), 8, 2000);
  Points<2> dense;
  for (int i = 0; i <= least; ++i) dense.push_back(at(static_cast<double>(i) / least));
  const double total = polyline_length<2>(dense);
  for (int count = 2; count < least && total > 0; count += 1 + count / 8) {
    Points<2> points = resample<2>(dense, count);
    double along = 0;
    bool near = true;
    for (std::size_t i = 1; near && i < dense.size(); ++i) {
      along += (dense[i] - dense[i - 1]).norm();
      const auto part = std::min(static_cast<std::size_t>(along / total * count), points.size() - 2);
      near = off_chord(dense[i], points[part], points[part + 1]) <= tolerance;
    }
    if (!near) continue;
    points.back() = s.to;
    return points;
  }
  return dense;
}

// Takes out vertices of straight lines that do not bend them.
void straighten(Sampled& line, const std::vector<bool>& between_lines) {
  const std::size_t n = line.points.size();
  if (n < 3) return;
  std::vector<bool> keep(n, true);
  std::size_t last = 0;
  for (std::size_t i = 1; i + (line.closed ? 0 : 1) < n; ++i) {
    const Vector2d& next = line.points[(i + 1) % n];
    bool on_line = between_lines[i];
    for (std::size_t k = last + 1; on_line && k <= i; ++k)
      on_line = off_chord(line.points[k], line.points[last], next) <= on_the_line;
    if (on_line)
      keep[i] = false;
    else
      last = i;
  }
  if (line.closed && between_lines[0]) {
    std::size_t next = 1;
    while (next < n && !keep[next]) ++next;
    if (next < n && last != 0 && last != next && off_chord(line.points[0], line.points[last], line.points[next]) <= on_the_line)
      keep[0] = false;
  }
  Sampled kept{{}, {}, line.closed, line.has_curves};
  for (std::size_t i = 0; i < n; ++i)
    if (keep[i]) {
      kept.points.push_back(line.points[i]);
      kept.bends.push_back(line.bends[i]);
    }
  line = std::move(kept);
}

}  // namespace

Sampled sampled(const SubPath& part, const Affine& to_metres, double tolerance, bool as_drawn) {
  const std::vector<Segment> segments = in_metres(part, to_metres);
  Sampled line;
  if (segments.empty()) return line;
  line.has_curves = std::any_of(segments.begin(), segments.end(), [](const Segment& s) { return s.curve; });
  line.closed = part.closed || (segments.size() > 1 && (segments.back().to - segments.front().from).norm() <= meeting);
  std::vector<bool> between_lines;
  const std::size_t n = segments.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Segment& s = segments[i];
    const bool begins = i == 0 && !line.closed;
    const Segment& before = segments[(i + n - 1) % n];
    const bool sharp = !begins && angle_between(way_in(before), way_out(s)) >= corner_angle;
    line.points.push_back(s.from);
    line.bends.push_back(!line.has_curves || begins ? Bend::unknown : sharp ? Bend::corner : Bend::smooth);
    between_lines.push_back(!begins && !before.curve && !s.curve);
    if (!s.curve) continue;
    const Points<2> inner = curve_points(s, tolerance);
    for (std::size_t k = 1; k + 1 < inner.size(); ++k) {
      line.points.push_back(inner[k]);
      line.bends.push_back(Bend::smooth);
      between_lines.push_back(false);
    }
  }
  if (!line.closed) {
    line.points.push_back(segments.back().to);
    line.bends.push_back(Bend::unknown);
    between_lines.push_back(false);
  }
  if (!as_drawn) straighten(line, between_lines);
  if (line.points.size() < 3) line.closed = false;
  return line;
}

}  // namespace toile::svg
