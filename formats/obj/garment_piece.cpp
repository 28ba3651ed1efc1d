#include "formats/obj/garment_piece.h"

#include <algorithm>
#include <cmath>

#include "formats/dxf_aama/turn_points.h"
#include "garment/units.h"
#include "geometry/self_crossing.h"

namespace toile {
namespace {

constexpr double corner_angle = 15 * units::degree;
constexpr double straight = .1e-3;  // m

Points<2> places(const Island& island, const std::vector<int>& loop) {
  Points<2> points;
  for (const int v : loop) points.push_back(island.flat.col(v));
  return points;
}

bool on_chord(const Points<2>& points) {
  const Eigen::Vector2d along = points.back() - points.front();
  if (!(along.norm() > 2 * straight)) return false;
  const Eigen::Vector2d across = Eigen::Vector2d(-along.y(), along.x()).normalized();
  return std::all_of(points.begin(), points.end(), [&](const Eigen::Vector2d& p) {
    const double at = along.dot(p - points.front()) / along.squaredNorm();
    return std::abs(across.dot(p - points.front())) <= straight && at > -1e-6 && at < 1 + 1e-6;
  });
}

}  // namespace

std::optional<IslandPiece> island_piece(const Island& island, const std::string& place, Report& report) {
  const std::string where = place + ":" + std::to_string(island.line) + ", piece '" + island.name + "'";
  std::vector<int> loop = island.loops.front();
  Points<2> ring = places(island, loop);
  if (first_self_crossing(ring)) {
    report.error("obj.overlapping-island", where, "the outline of the piece crosses itself in the texture coordinates (UV)",
                 "lay the piece flat without overlaps");
    return std::nullopt;
  }
  std::vector<bool> corner = aama::corners_by_angle(ring, corner_angle);
  // The outline begins at the corner that comes first in the file.
  std::size_t first = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    if (corner[i] && (!corner[first] || loop[i] < loop[first])) first = i;
  corner[first] = true;
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
  std::rotate(corner.begin(), corner.begin() + static_cast<std::ptrdiff_t>(first), corner.end());

  IslandPiece made;
  made.piece.name = made.panel.name = island.name;
  made.panel.rest = island.flat;
  made.panel.triangles = island.triangles;
  for (std::size_t from = 0; from < ring.size();) {
    std::size_t to = from + 1;
    while (to < ring.size() && !corner[to]) ++to;
    Points<2> points(ring.begin() + static_cast<std::ptrdiff_t>(from), ring.begin() + static_cast<std::ptrdiff_t>(to));
    points.push_back(ring[to % ring.size()]);
    const double length = polyline_length<2>(points);
    const int edge = static_cast<int>(made.piece.outline.size());
    double run = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (i > 0) run += (points[i] - points[i - 1]).norm();
      made.panel.boundary.push_back({loop[from + i], edge, length > 0 ? run / length : 0});
    }
    if (on_chord(points)) points = {points.front(), points.back()};
    Edge drawn;
    drawn.id = "e" + std::to_string(edge);
    for (std::size_t i = 0; i < points.size(); ++i) drawn.points.push_back({points[i], i == 0 || i + 1 == points.size(), {}});
    made.piece.outline.push_back(std::move(drawn));
    from = to;
  }
  for (std::size_t l = 1; l < island.loops.size(); ++l) {
    InternalLine hole{places(island, island.loops[l]), true};
    hole.points.push_back(hole.points.front());
    made.piece.internal_lines.push_back(std::move(hole));
  }
  if (island.loops.size() > 1)
    report.note("obj.hole", where, std::to_string(island.loops.size() - 1) + " holes of the piece were taken as cut-outs");
  return made;
}

std::vector<BoundaryVertex> mirrored_boundary(const std::vector<BoundaryVertex>& boundary) {
  std::vector<BoundaryVertex> turned(boundary.rbegin(), boundary.rend());
  if (!turned.empty()) std::rotate(turned.begin(), turned.end() - 1, turned.end());
  return turned;
}

}  // namespace toile
