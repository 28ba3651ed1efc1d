#include "draft/runs.h"

#include <algorithm>
#include <stdexcept>

#include "geometry/polyline.h"

namespace toile {
namespace {

// Pattern files are written to a tenth or a hundredth of a millimetre: edges this near to one line were drawn on one line.
constexpr double in_line = 5e-5;
// A curve whose chord is shorter than this share of its length is cut in two, so that chords carry its shape well.
constexpr double least_chord = 0.5;

using Line = std::vector<Eigen::Vector2d>;

bool is_one_line(const Line& points) {
  const Eigen::Vector2d chord = points.back() - points.front();
  const double length = chord.norm();
  double before = 0;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d d = point - points.front();
    const double along = d.dot(chord) / length;
    if (!(std::abs(chord.x() * d.y() - chord.y() * d.x()) <= in_line * length) || along < before - in_line) return false;
    before = along;
  }
  return length > 0;
}

Line joined(const std::vector<Line>& lines, std::size_t first, std::size_t count) {
  Line all;
  for (std::size_t i = 0; i < count; ++i) {
    const Line& line = lines[(first + i) % lines.size()];
    all.insert(all.end(), line.begin() + (i > 0), line.end());
  }
  return all;
}

void add_straight(Sides& sides, const std::vector<Line>& lines, std::size_t first, std::size_t count) {
  Run run;
  const Line all = joined(lines, first, count);
  run.length = polyline_length<2>(all);
  double before = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t edge = (first + i) % lines.size();
    const double begin = before / run.length;
    before += polyline_length<2>(lines[edge]);
    run.parts.push_back({static_cast<int>(edge), 0, 1, begin, i + 1 == count ? 1.0 : before / run.length});
  }
  sides.corners.push_back(all.front());
  sides.runs.push_back(std::move(run));
}

// Points `from` .. `to` of a curved edge, whose arc lengths from its start are `arc`.
void add_curve(Sides& sides, int edge, const Line& points, const std::vector<double>& arc, std::size_t from, std::size_t to) {
  const Eigen::Vector2d chord = points[to] - points[from];
  const double length = arc[to] - arc[from];
  if (chord.norm() < least_chord * length && to - from >= 2) {
    const double half = (arc[from] + arc[to]) / 2;
    std::size_t middle = from + 1;
    while (middle + 1 < to && std::abs(arc[middle + 1] - half) < std::abs(arc[middle] - half)) ++middle;
    add_curve(sides, edge, points, arc, from, middle);
    add_curve(sides, edge, points, arc, middle, to);
    return;
  }
  if (chord.norm() == 0) throw std::invalid_argument("redraw: edge " + std::to_string(edge) + " has no length");
  Run run;
  run.straight = false;
  run.length = length;
  run.parts.push_back({edge, arc[from] / arc.back(), to + 1 == points.size() ? 1.0 : arc[to] / arc.back(), 0, 1});
  const Eigen::Vector2d back = Eigen::Vector2d(chord.x(), -chord.y()) / chord.squaredNorm();
  for (std::size_t i = from; i <= to; ++i) {
    run.at.push_back((arc[i] - arc[from]) / length);
    run.shape.push_back(on_chord(points[i] - points[from], back));
  }
  run.at.back() = 1;
  run.shape.back() = Eigen::Vector2d::UnitX();
  sides.corners.push_back(points[from]);
  sides.runs.push_back(std::move(run));
}

}  // namespace

Sides sides_of(const Piece& piece) {
  std::vector<Line> lines;
  for (const Edge& edge : piece.outline) lines.push_back(positions(edge));
  const std::size_t count = lines.size();
  const auto continues = [&](std::size_t i) {  // edge i goes on in the line of the one before it
    return count > 2 && is_one_line(joined(lines, (i + count - 1) % count, 2));
  };
  std::size_t start = 0;
  while (start < count && continues(start)) ++start;
  if (start == count) throw std::invalid_argument("redraw: piece '" + piece.name + "' is one line");
  Sides sides;
  for (std::size_t done = 0; done < count;) {
    const std::size_t first = (start + done) % count;
    if (is_one_line(lines[first])) {
      std::size_t along = 1;
      while (done + along < count && is_one_line(joined(lines, first, along + 1))) ++along;
      add_straight(sides, lines, first, along);
      done += along;
    } else {
      std::vector<double> arc{0};
      for (std::size_t i = 1; i < lines[first].size(); ++i)
        arc.push_back(arc.back() + (lines[first][i] - lines[first][i - 1]).norm());
      add_curve(sides, static_cast<int>(first), lines[first], arc, 0, lines[first].size() - 1);
      ++done;
    }
  }
  return sides;
}

Eigen::Vector2d shape_at(const Run& run, double t) {
  if (run.straight) return {t, 0};
  const auto after = std::upper_bound(run.at.begin(), run.at.end(), t);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - run.at.begin(), 1, static_cast<std::ptrdiff_t>(run.at.size()) - 1));
  const double width = run.at[i] - run.at[i - 1];
  const double u = width > 0 ? (t - run.at[i - 1]) / width : 0;
  return (1 - u) * run.shape[i - 1] + u * run.shape[i];
}

}  // namespace toile
