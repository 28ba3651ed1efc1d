#include "formats/svg_read/grain.h"

#include <algorithm>

namespace toile::svg {
namespace {

using Eigen::Vector2d;

constexpr double shortest = 25e-3, beside = 25e-3, head = 30e-3, touching = 2.5e-3;  // m

struct Shaft {
  Vector2d from = Vector2d::Zero(), to = Vector2d::Zero();
  bool heads = false;  // drawn in one with it
  double length() const { return (to - from).norm(); }
};

Shaft shaft_of(const Points<2>& points) {
  Shaft shaft;
  double rest = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double length = (points[i] - points[i - 1]).norm();
    rest += length;
    if (length > shaft.length()) shaft = {points[i - 1], points[i], false};
  }
  rest -= shaft.length();
  shaft.heads = points.size() >= 5 && rest > 0 && rest < 4 * head && rest < .6 * shaft.length();
  return shaft;
}

bool has_head(const Drawing& drawing, const PieceParts& parts, std::size_t shaft, const Vector2d& end) {
  return std::any_of(parts.lines.begin(), parts.lines.end(), [&](std::size_t i) {
    const Points<2>& points = drawing.lines[i].shape.points;
    if (i == shaft || points.size() > 6) return false;
    double nearest = 1, farthest = 0;
    for (const Vector2d& p : points) {
      nearest = std::min(nearest, (p - end).norm());
      farthest = std::max(farthest, (p - end).norm());
    }
    return nearest < touching && farthest < head;
  });
}

}  // namespace

void find_grain(const Drawing& drawing, const PieceParts& parts, const Label& label, std::vector<Role>& roles) {
  std::size_t best = 0;
  double longest = shortest;
  for (const std::size_t i : parts.lines) {
    if (roles[i] == Role::grain) return;
    const DrawnLine& line = drawing.lines[i];
    if (roles[i] != Role::unknown && roles[i] != Role::internal) continue;
    if (line.shape.has_curves || line.shape.points.size() > 12) continue;
    const Shaft shaft = shaft_of(line.shape.points);
    if (shaft.length() <= longest) continue;
    const bool labelled = std::any_of(label.grain_at.begin(), label.grain_at.end(), [&](const Vector2d& at) {
      return nearest_on<2>({shaft.from, shaft.to}, at).distance < beside;
    });
    const bool markers = line.marker_start != "none" || line.marker_end != "none";
    const bool heads = shaft.heads || (has_head(drawing, parts, i, shaft.from) && has_head(drawing, parts, i, shaft.to));
    if (!labelled && !heads && !(markers && line.shape.points.size() == 2)) continue;
    longest = shaft.length();
    best = i + 1;
  }
  if (best == 0) return;
  roles[best - 1] = Role::grain;
  const Shaft shaft = shaft_of(drawing.lines[best - 1].shape.points);
  for (const std::size_t i : parts.lines)
    if (roles[i] == Role::unknown || roles[i] == Role::internal)
      for (const Vector2d& end : {shaft.from, shaft.to}) {
        PieceParts one;
        one.lines = {i};
        if (has_head(drawing, one, best - 1, end)) roles[i] = Role::text;
      }
}

}  // namespace toile::svg
