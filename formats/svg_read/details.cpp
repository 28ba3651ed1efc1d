#include "formats/svg_read/details.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/turn_points.h"
#include "garment/units.h"

namespace toile::svg {
namespace {

using Eigen::Vector2d;

constexpr double on_outline = .3e-3;  // m
constexpr double mark_off = 3e-3;     // m, a notch drawn as a symbol may stand this far from its line
constexpr double shortest_notch = 1.5e-3, longest_notch = 20e-3;  // m
constexpr double largest_hole = 25e-3;                            // m

struct Lines {
  const Points<2>& sew;
  const std::optional<Points<2>>& cut;

  double off(const Vector2d& at) const {
    const double sew_off = aama::distance_to_ring(sew, at);
    return cut ? std::min(sew_off, aama::distance_to_ring(*cut, at)) : sew_off;
  }
  // Unit direction of the nearest outline there.
  Vector2d along(const Vector2d& at) const {
    const bool by_cut = cut && aama::distance_to_ring(*cut, at) < aama::distance_to_ring(sew, at);
    const Points<2> loop = aama::closed_polyline(by_cut ? *cut : sew);
    return direction_at<2>(loop, nearest_on<2>(loop, at).at);
  }
};

Vector2d middle_of(const Points<2>& points) {
  Vector2d low = points.front(), high = points.front();
  for (const Vector2d& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (low + high) / 2;
}

double extent(const Points<2>& points) {
  double most = 0;
  const Vector2d middle = middle_of(points);
  for (const Vector2d& p : points) most = std::max(most, 2 * (p - middle).norm());
  return most;
}

aama::DrawnNotch notch_of(const DrawnLine& line, const Lines& lines) {
  const Points<2>& points = line.shape.points;
  aama::DrawnNotch notch;
  notch.line = line.names.line;
  notch.at = middle_of(points);
  if (!line.shape.closed && points.size() == 2) {
    const bool turned = lines.off(points[1]) < lines.off(points[0]);
    notch.at = points[turned ? 1 : 0];
    notch.direction = (points[turned ? 0 : 1] - notch.at).normalized();
    notch.depth = (points[1] - points[0]).norm();
    notch.from_line = true;
  } else if (points.size() == 3) {
    // The apex is the point farthest from the line the other two stand on.
    std::size_t apex = 1;
    if (line.shape.closed)
      for (std::size_t i = 0; i < 3; ++i)
        if (lines.off(points[i]) > lines.off(points[apex])) apex = i;
    const Vector2d &a = points[(apex + 1) % 3], &b = points[(apex + 2) % 3];
    notch.kind = NotchKind::v;
    notch.at = (a + b) / 2;
    notch.width = (a - b).norm();
    notch.depth = (points[apex] - notch.at).norm();
    if (notch.depth > 0) notch.direction = (points[apex] - notch.at) / notch.depth;
  }
  return notch;
}

// A short line that stands on an outline, across it, or a small V both ends of which do.
bool looks_like_notch(const DrawnLine& line, const Lines& lines) {
  const Points<2>& points = line.shape.points;
  if (line.shape.has_curves || points.size() > 3 || points.size() < 2) return false;
  const double size = extent(points);
  if (size < shortest_notch || size > longest_notch) return false;
  if (points.size() == 2) {
    const bool turned = lines.off(points[1]) < lines.off(points[0]);
    const Vector2d foot = points[turned ? 1 : 0];
    const Vector2d way = (points[turned ? 0 : 1] - foot).normalized(), along = lines.along(foot);
    return lines.off(foot) <= on_outline && std::abs(way.x() * along.y() - way.y() * along.x()) > .7 &&
           lines.off(points[turned ? 0 : 1]) > on_outline;
  }
  int feet = 0;
  for (const Vector2d& p : points) feet += lines.off(p) <= on_outline;
  return feet == 2 && lines.off(points[1]) > (line.shape.closed ? -1.0 : on_outline);
}

bool looks_like_hole(const DrawnLine& line) {
  return line.shape.closed && line.shape.has_curves && line.shape.points.size() >= 6 &&
         extent(line.shape.points) <= largest_hole;
}

}  // namespace

void sort_details(const Drawing& drawing, const std::vector<Role>& roles, const PieceParts& parts, const Points<2>& sew,
                  const std::optional<Points<2>>& cut, const std::optional<std::pair<Vector2d, Vector2d>>& fold,
                  aama::DrawnPiece& drawn) {
  const Lines lines{sew, cut};
  const auto on_fold = [&](const Vector2d& at) {
    return fold && nearest_on<2>({fold->first, fold->second}, at).distance <= 1e-3 && (at - fold->first).norm() > 2e-3 &&
           (at - fold->second).norm() > 2e-3;
  };
  const auto place_mark = [&](const Vector2d& at, int line) {
    aama::DrawnNotch notch;
    notch.at = at;
    notch.line = line;
    if (lines.off(at) <= mark_off && !on_fold(at))
      drawn.notches.push_back(notch);
    else
      drawn.drill_holes.push_back({at, 0});
  };
  for (const std::size_t i : parts.lines) {
    const DrawnLine& line = drawing.lines[i];
    const aama::Run run{line.shape.points, line.shape.closed, line.names.line};
    switch (roles[i]) {
      case Role::grain:
        drawn.grain.push_back(run);
        break;
      case Role::fold:  // told by `fold`
      case Role::text:
      case Role::test_square:
      case Role::page:
      case Role::decoration:
        break;
      case Role::notch: {
        const aama::DrawnNotch notch = notch_of(line, lines);
        if (extent(line.shape.points) > 2 * longest_notch)
          drawn.internal_lines.push_back(run);
        else if (lines.off(notch.at) > 2 * longest_notch)
          drawn.drill_holes.push_back({notch.at, 0});
        else
          drawn.notches.push_back(notch);
        break;
      }
      case Role::drill:
        if (extent(line.shape.points) > largest_hole)
          drawn.internal_lines.push_back(run);
        else
          drawn.drill_holes.push_back({middle_of(line.shape.points), line.shape.closed ? extent(line.shape.points) : 0});
        break;
      case Role::cut_out:
        drawn.cut_outs.push_back(run);
        break;
      default:
        if (looks_like_notch(line, lines))
          drawn.notches.push_back(notch_of(line, lines));
        else if (roles[i] != Role::internal && looks_like_hole(line))
          drawn.drill_holes.push_back({middle_of(line.shape.points), extent(line.shape.points)});
        else
          drawn.internal_lines.push_back(run);
    }
  }
  for (const std::size_t i : parts.marks) {
    const DrawnMark& mark = drawing.marks[i];
    if (role_in_words(mark.symbol) == Role::notch)
      place_mark(mark.at, mark.names.line);
    else
      drawn.drill_holes.push_back({mark.at, 0});
  }
}

std::vector<bool> corners_of(const Ring& ring) {
  constexpr double lone_corner = 5 * units::degree, long_side = 20e-3;  // m
  std::vector<bool> corner = aama::corners_by_angle(ring.points, 20 * units::degree);
  const std::vector<bool> sharp = corner;
  const std::size_t n = ring.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (ring.bends[i] != Bend::unknown) {
      corner[i] = ring.bends[i] == Bend::corner;
      continue;
    }
    // A slight bend alone between two long straight sides is no vertex of a sampled curve.
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    const Vector2d a = ring.points[i] - ring.points[before], b = ring.points[after] - ring.points[i];
    const double turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
    if (!corner[i] && sharp[before] && sharp[after] && turn > lone_corner && a.norm() > long_side && b.norm() > long_side)
      corner[i] = true;
  }
  return corner;
}

}  // namespace toile::svg
