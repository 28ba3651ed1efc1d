#include "triangulate/intervals.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "garment/units.h"

namespace toile {
namespace {

constexpr double same_mark = 0.5e-3;     // m
constexpr double kink = 30 * degree;     // a corner inside an edge that the mesh must not cut off
constexpr std::size_t most_marks = 512;  // on one edge; only a seam that maps an edge into a part of itself asks for more

struct EdgeMarks {
  double length = 0;
  std::vector<double> marks;  // sorted, 0 and 1 among them

  double tolerance() const { return std::min(same_mark / length, .1); }

  // Index of the mark at `at`, or of the gap before marks[index] when there is none.
  std::pair<std::size_t, bool> find(double at) const {
    const auto next = std::lower_bound(marks.begin(), marks.end(), at);
    const auto index = static_cast<std::size_t>(next - marks.begin());
    const double after = next == marks.end() ? 2 : *next - at;
    const double before = next == marks.begin() ? 2 : at - *(next - 1);
    if (std::min(before, after) > tolerance()) return {index, false};
    return {before < after ? index - 1 : index, true};
  }

  bool add(double at) {
    const auto [index, known] = find(at);
    if (!known) marks.insert(marks.begin() + static_cast<std::ptrdiff_t>(index), at);
    return !known;
  }
};

using Marks = std::vector<std::vector<EdgeMarks>>;  // [piece][edge]

EdgeMarks& on(Marks& marks, const SpanPlace& span) {
  return marks[static_cast<std::size_t>(span.piece)][static_cast<std::size_t>(span.edge)];
}

void mark_kinks(const Edge& edge, EdgeMarks& marks) {
  double before = 0;
  for (std::size_t i = 1; i + 1 < edge.points.size(); ++i) {
    const Eigen::Vector2d u = edge.points[i].at - edge.points[i - 1].at;
    const Eigen::Vector2d v = edge.points[i + 1].at - edge.points[i].at;
    before += u.norm();
    if (u.norm() > 0 && v.norm() > 0 && u.dot(v) < std::cos(kink) * u.norm() * v.norm()) marks.add(before / marks.length);
  }
}

// Carries every mark inside `from` over to `to`; true when that added one.
bool carry(const EdgeMarks& from, const SpanPlace& from_span, EdgeMarks& to, const SpanPlace& to_span) {
  const double low = std::min(from_span.begin, from_span.end) + from.tolerance();
  const double high = std::max(from_span.begin, from_span.end) - from.tolerance();
  bool added = false;
  for (const double mark : std::vector<double>(from.marks)) {
    if (mark <= low || mark >= high) continue;
    const double along = (mark - from_span.begin) / (from_span.end - from_span.begin);
    added |= to.add(to_span.begin + along * (to_span.end - to_span.begin));
  }
  return added;
}

Marks all_marks(const Pattern& pattern, const std::vector<SeamPlace>& seams) {
  Marks marks(pattern.pieces.size());
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    for (const Edge& edge : pattern.pieces[p].outline) {
      EdgeMarks ends{length(edge), {0, 1}};
      marks[p].push_back(ends);
    }
  for (const SeamPlace& seam : seams)
    for (const SpanPlace* span : {&seam.a, &seam.b})
      for (const double end : {span->begin, span->end}) on(marks, *span).add(end);
  for (std::size_t p = 0; p < pattern.pieces.size(); ++p)
    for (std::size_t e = 0; e < pattern.pieces[p].outline.size(); ++e) mark_kinks(pattern.pieces[p].outline[e], marks[p][e]);

  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t s = 0; s < seams.size(); ++s) {
      EdgeMarks& a = on(marks, seams[s].a);
      EdgeMarks& b = on(marks, seams[s].b);
      changed |= carry(a, seams[s].a, b, seams[s].b);
      changed |= carry(b, seams[s].b, a, seams[s].a);
      if (std::max(a.marks.size(), b.marks.size()) > most_marks)
        refuse_seam("seam.ends-nearly-meet", pattern.seams[s], "its copies divide each other's edges without end",
                    "Sew equal parts of the edge to each other");
    }
  }
  return marks;
}

int root_of(std::vector<int>& parent, int i) {
  while (parent[static_cast<std::size_t>(i)] != i)
    i = parent[static_cast<std::size_t>(i)] = parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(i)])];
  return i;
}

}  // namespace

std::vector<Interval> intervals(const Pattern& pattern, const std::vector<SeamPlace>& seams) {
  Marks marks = all_marks(pattern, seams);
  std::vector<Interval> parts;
  std::vector<std::vector<int>> first(pattern.pieces.size());  // [piece][edge] -> index of the edge's first interval
  for (std::size_t p = 0; p < marks.size(); ++p)
    for (std::size_t e = 0; e < marks[p].size(); ++e) {
      const EdgeMarks& edge = marks[p][e];
      first[p].push_back(static_cast<int>(parts.size()));
      for (std::size_t i = 0; i + 1 < edge.marks.size(); ++i)
        parts.push_back({static_cast<int>(p), static_cast<int>(e), edge.marks[i], edge.marks[i + 1],
                         (edge.marks[i + 1] - edge.marks[i]) * edge.length, 0});
    }

  std::vector<int> parent(parts.size());
  std::iota(parent.begin(), parent.end(), 0);
  for (std::size_t s = 0; s < seams.size(); ++s) {
    const auto run = [&](const SpanPlace& span) {
      const EdgeMarks& edge = on(marks, span);
      const int base = first[static_cast<std::size_t>(span.piece)][static_cast<std::size_t>(span.edge)];
      std::vector<int> parts_of_span;
      const auto low = edge.find(std::min(span.begin, span.end)).first, high = edge.find(std::max(span.begin, span.end)).first;
      for (std::size_t i = low; i < high; ++i) parts_of_span.push_back(base + static_cast<int>(i));
      if (span.begin > span.end) std::reverse(parts_of_span.begin(), parts_of_span.end());
      return parts_of_span;
    };
    const std::vector<int> a = run(seams[s].a), b = run(seams[s].b);
    if (a.size() != b.size())
      refuse_seam("seam.ends-nearly-meet", pattern.seams[s],
                  "an end of another seam falls less than " + in_mm(same_mark) + " beside one of its own, across the two edges",
                  "Let both ends fall on the same place");
    for (std::size_t i = 0; i < a.size(); ++i) {
      const int x = root_of(parent, a[i]), y = root_of(parent, b[i]);
      parent[static_cast<std::size_t>(std::max(x, y))] = std::min(x, y);
    }
  }
  int groups = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int root = root_of(parent, static_cast<int>(i));
    parts[i].group = root == static_cast<int>(i) ? groups++ : parts[static_cast<std::size_t>(root)].group;
  }
  return parts;
}

}  // namespace toile
