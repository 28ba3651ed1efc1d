#include "formats/dxf_aama/graded_lines.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>

#include "formats/dxf_aama/chains.h"
#include "formats/dxf_aama/match_lines.h"
#include "formats/dxf_aama/unfold.h"

namespace toile::aama {
namespace {

using Eigen::Vector2d;
using Lines = std::vector<Run> DrawnPiece::*;

constexpr Lines kinds_of_line[] = {&DrawnPiece::dense_sew,      &DrawnPiece::sew,
                                   &DrawnPiece::dense_cut,      &DrawnPiece::cut,
                                   &DrawnPiece::internal_lines, &DrawnPiece::dense_internal_lines,
                                   &DrawnPiece::cut_outs,       &DrawnPiece::dense_cut_outs,
                                   &DrawnPiece::grain};

bool drawn_alike(const std::vector<Run>& a, const std::vector<Run>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Run& x, const Run& y) { return x.points.size() == y.points.size() && x.closed == y.closed; });
}

Eigen::Vector2d middle(const Points<2>& points) {
  Vector2d low = points.front(), high = low;
  for (const Vector2d& p : points) low = low.cwiseMin(p), high = high.cwiseMax(p);
  return (low + high) / 2;
}

// Whether a closed line with as many vertices begins at another corner: by their numbers the vertices would go much farther
// than from corner to corner.
bool begins_elsewhere(const std::vector<Run>& a, const std::vector<Run>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::vector<Chain> from = chains({a[i]}), to = chains({b[i]});
    if (!a[i].closed || from.size() != 1 || to.size() != 1) continue;
    const LineMatch match(from.front(), to.front());
    const Vector2d shift = middle(b[i].points) - middle(a[i].points);
    double by_number = 0, by_corner = 0;
    for (std::size_t k = 0; k < a[i].points.size(); ++k) {
      by_number += (b[i].points[k] - a[i].points[k] - shift).squaredNorm();
      by_corner += (match(a[i].points[k]) - a[i].points[k] - shift).squaredNorm();
    }
    if (by_number > 4 * by_corner + 1e-4 * static_cast<double>(a[i].points.size())) return true;
  }
  return false;
}

Points<2> whole(const Run& run) { return run.closed ? closed_polyline(run.points) : run.points; }

// The lines of one kind in one size, each as the sample size's vertices; nothing when they cannot be told apart.
std::optional<std::vector<Points<2>>> along(const std::vector<Run>& sample, const std::vector<Run>& other) {
  const std::vector<Chain> from = chains(sample), to = chains(other);
  if (from.size() != to.size()) return {};
  std::vector<LineMatch> matches;
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i].closed != to[i].closed || from[i].points.size() < 2 || to[i].points.size() < 2) return {};
    matches.emplace_back(from[i], to[i]);
  }
  std::vector<Points<2>> moved;
  for (const Run& run : sample) {
    std::size_t mine = from.size();
    double best = INFINITY;
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (run.points.empty()) continue;
      const double off =
          nearest_on<2>(from[i].closed ? closed_polyline(from[i].points) : from[i].points, run.points[run.points.size() / 2])
              .distance;
      if (off < best) best = off, mine = i;
    }
    if (mine == from.size()) return {};
    Points<2> points;
    for (const Vector2d& p : whole(run)) points.push_back(matches[mine](p));
    moved.push_back(std::move(points));
  }
  return moved;
}

template <class Mark>
void add_marks(std::vector<GradedLine>& to, const std::vector<const DrawnPiece*>& sizes, const std::vector<Mark>& sample,
               std::vector<Mark> DrawnPiece::*marks) {
  for (const DrawnPiece* size : sizes)
    if ((size->*marks).size() != sample.size()) return;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    GradedLine mark{{sample[i].at}, {}};
    for (const DrawnPiece* size : sizes) mark.in_size.push_back({(size->*marks)[i].at});
    to.push_back(std::move(mark));
  }
}

// Moves of the vertices of a chain, interpolated by arc length between those that have one; false when none has.
bool interpolated(const Chain& chain, std::vector<std::optional<Vector2d>>& moves) {
  const std::size_t n = chain.points.size();
  std::vector<std::size_t> given;
  for (std::size_t i = 0; i < n; ++i)
    if (moves[i]) given.push_back(i);
  if (given.empty()) return false;
  const std::vector<std::optional<Vector2d>> rules = moves;
  const auto step = [&](std::size_t i) { return (chain.points[(i + 1) % n] - chain.points[i]).norm(); };
  for (std::size_t g = 0; g < given.size(); ++g) {
    const std::size_t begin = given[g], end = given[(g + 1) % given.size()];
    if (!chain.closed && g + 1 == given.size()) break;
    double length = step(begin), run = 0;
    for (std::size_t i = (begin + 1) % n; i != end; i = (i + 1) % n) length += step(i);
    for (std::size_t i = begin; (i = (i + 1) % n) != end;) {
      run += step((i + n - 1) % n);
      const double t = length > 0 ? run / length : 0;
      moves[i] = (1 - t) * *rules[begin] + t * *rules[end];
    }
  }
  if (chain.closed) return true;
  for (std::size_t i = 0; i < given.front(); ++i) moves[i] = *rules[given.front()];
  for (std::size_t i = given.back() + 1; i < n; ++i) moves[i] = *rules[given.back()];
  return true;
}

// The x axis of the rules: the grade reference line, without regard to which end is drawn first.
Eigen::Matrix2d rule_axes(const DrawnPiece& piece) {
  Eigen::Matrix2d axes = piece.linear;
  for (const Run& run : piece.grade_reference) {
    if (run.points.size() < 2 || (run.points.back() - run.points.front()).norm() <= same_vertex) continue;
    const Vector2d drawn = axes.inverse() * (run.points.back() - run.points.front());
    Vector2d along = drawn.normalized();
    if (along.x() < -1e-6) along = -along;
    Eigen::Matrix2d turn;
    turn << along.x(), -along.y(), along.y(), along.x();
    return axes * turn;
  }
  return axes;
}

}  // namespace

GradedLines nest_lines(const DrawnPiece& sample, const std::vector<const DrawnPiece*>& sizes,
                       const std::vector<std::string>& size_names, Report& report) {
  GradedLines graded;
  std::string along_names;
  std::vector<bool> has_outline(sizes.size(), false), differs(sizes.size(), false);
  const auto add = [&](const std::vector<Run>& runs, Lines kind, bool outline) {
    std::vector<GradedLine> lines;
    for (const Run& run : runs) lines.push_back({whole(run), {}});
    bool complete = true;
    for (std::size_t s = 0; s < sizes.size() && complete; ++s) {
      const std::vector<Run>& other = sizes[s]->*kind;
      if (drawn_alike(runs, other) && !begins_elsewhere(runs, other)) {
        for (std::size_t i = 0; i < runs.size(); ++i) lines[i].in_size.push_back(whole(other[i]));
      } else if (const auto moved = along(runs, other)) {
        for (std::size_t i = 0; i < runs.size(); ++i) lines[i].in_size.push_back((*moved)[i]);
        differs[s] = differs[s] || outline;
      } else {
        complete = false;
      }
    }
    if (!complete) return;
    for (std::size_t s = 0; s < sizes.size(); ++s) has_outline[s] = has_outline[s] || (outline && !runs.empty());
    for (GradedLine& line : lines)
      if (!line.points.empty()) graded.lines.push_back(std::move(line));
  };
  for (const Lines kind : kinds_of_line)
    add(sample.*kind, kind,
        kind == &DrawnPiece::sew || kind == &DrawnPiece::cut || kind == &DrawnPiece::dense_sew ||
            kind == &DrawnPiece::dense_cut);
  const std::size_t before_mirror = graded.lines.size();
  add(sample.mirror, &DrawnPiece::mirror, false);
  double longest = 0;
  for (std::size_t i = before_mirror; i < graded.lines.size(); ++i) {
    const double length = (graded.lines[i].points.back() - graded.lines[i].points.front()).norm();
    if (length > longest) longest = length, graded.mirror = static_cast<int>(i);
  }
  add_marks(graded.drills, sizes, sample.drill_holes, &DrawnPiece::drill_holes);
  add_marks(graded.notches, sizes, sample.notches, &DrawnPiece::notches);

  for (std::size_t s = 0; s < sizes.size(); ++s)
    if (differs[s]) along_names += (along_names.empty() ? "" : ", ") + size_names[s];
  if (!has_outline.empty() && !has_outline.front()) {
    report.warn("aama.not-graded", sample.place(),
                "its outlines cannot be matched between the sizes; all sizes have the sample size's shape",
                "draw the piece in every size with the same lines");
    graded.lines.clear();
    graded.mirror = -1;
  } else if (!along_names.empty()) {
    report.note(
        "aama.nest-along", sample.place(),
        "drawn with other vertices in size " + along_names + "; points are matched from corner to corner along the outline");
  }
  return graded;
}

GradedLines ruled_lines(const DrawnPiece& sample, const GradeTable& table, double unit, Report& report) {
  GradedLines graded;
  const Eigen::Matrix2d axes = rule_axes(sample) * (unit / sample.unit);
  std::set<int> missing;
  const auto rule_of = [&](const RuleMark& mark) -> const std::vector<Vector2d>* {
    const auto found = table.rules.find(mark.rule);
    if (found == table.rules.end()) missing.insert(mark.rule);
    return found == table.rules.end() ? nullptr : &found->second;
  };
  std::size_t ruled_outlines = 0;
  std::vector<GradedLine> unruled;
  for (const Lines kind : kinds_of_line) {
    const bool outline = kind == &DrawnPiece::sew || kind == &DrawnPiece::cut || kind == &DrawnPiece::dense_sew ||
                         kind == &DrawnPiece::dense_cut;
    for (const Chain& chain : chains(sample.*kind)) {
      std::vector<const std::vector<Vector2d>*> rules(chain.points.size(), nullptr);
      for (const RuleMark& mark : sample.grade_rules) {
        if (mark.role == Role::notch || mark.role == Role::drill_hole) continue;
        for (std::size_t i = 0; i < chain.points.size(); ++i)
          if (!rules[i] && (chain.points[i] - mark.at).norm() <= sample.tolerance) rules[i] = rule_of(mark);
      }
      GradedLine line{chain.closed ? closed_polyline(chain.points) : chain.points, {}};
      bool any = true;
      for (std::size_t s = 0; s < table.sizes.size() && any; ++s) {
        std::vector<std::optional<Vector2d>> moves(chain.points.size());
        for (std::size_t i = 0; i < moves.size(); ++i)
          if (rules[i]) moves[i] = axes * (*rules[i])[s];
        any = interpolated(chain, moves);
        if (!any) break;
        Points<2> moved;
        for (std::size_t i = 0; i < line.points.size(); ++i) moved.push_back(line.points[i] + *moves[i % moves.size()]);
        line.in_size.push_back(std::move(moved));
      }
      if (any) {
        ruled_outlines += outline;
        graded.lines.push_back(std::move(line));
      }
    }
  }
  for (const RuleMark& mark : sample.grade_rules) {
    if (mark.role != Role::notch && mark.role != Role::drill_hole) continue;
    const std::vector<Vector2d>* moves = rule_of(mark);
    if (!moves) continue;
    GradedLine point{{mark.at}, {}};
    for (const Vector2d& move : *moves) point.in_size.push_back({mark.at + axes * move});
    (mark.role == Role::notch ? graded.notches : graded.drills).push_back(std::move(point));
  }
  if (ruled_outlines == 0) graded.lines.clear();
  // The mirror line is an edge of the outline and moves with it.
  if (const std::optional<Axis> axis = mirror_axis(sample); axis && ruled_outlines > 0) {
    const auto longest = std::max_element(sample.mirror.begin(), sample.mirror.end(), [](const Run& a, const Run& b) {
      return (a.points.back() - a.points.front()).norm() < (b.points.back() - b.points.front()).norm();
    });
    GradedLine mirror{{longest->points.front(), longest->points.back()}, std::vector<Points<2>>(table.sizes.size())};
    for (const Vector2d& end : mirror.points) {
      const GradedLine* nearest = nullptr;
      std::size_t vertex = 0;
      double best = INFINITY;
      for (const GradedLine& line : graded.lines)
        for (std::size_t i = 0; i < line.points.size(); ++i)
          if ((line.points[i] - end).norm() < best) best = (line.points[i] - end).norm(), nearest = &line, vertex = i;
      for (std::size_t s = 0; s < table.sizes.size(); ++s)
        mirror.in_size[s].push_back(end + nearest->in_size[s][vertex] - nearest->points[vertex]);
    }
    graded.mirror = static_cast<int>(graded.lines.size());
    graded.lines.push_back(std::move(mirror));
  }
  if (!missing.empty()) {
    std::string numbers;
    for (const int number : missing) numbers += " " + std::to_string(number);
    report.warn("aama.rule-missing", sample.place(),
                "the grade rule table has no rule" + numbers + "; points with it move as their neighbours do",
                "export piece and rule table together");
  }
  return graded;
}

}  // namespace toile::aama
