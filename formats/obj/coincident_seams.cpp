#include "formats/obj/coincident_seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "garment/welds.h"

namespace toile {
namespace {

using Cell = std::array<std::int64_t, 3>;

double at_end(double fraction) {
  if (std::abs(fraction) < 1e-9) return 0;
  return std::abs(1 - fraction) < 1e-9 ? 1 : fraction;
}

// Walks along runs of welded segments.
class Runs {
 public:
  explicit Runs(const GarmentMesh& garment)
      : garment_(garment), segments_(boundary_segments(garment)), done_(segments_.size(), false) {}

  struct Run {
    int first_a, last_a, first_b, last_b;  // segments, in the order of a
    bool same_way;                         // b's panel runs along with a's: right to wrong
  };

  // The run that begins with segment `i`, if it is not in one yet.
  std::optional<Run> from(int i) {
    if (done_[at(i)]) return std::nullopt;
    for (const int mate : segment(i).mates) {
      if (done_[at(mate)] || mate == i) continue;
      const bool same_way = along(i, mate);
      Run run{i, i, mate, mate, same_way};
      take(i, mate);
      for (;;) {
        const int k = step(run.last_a, 1), m = step(run.last_b, same_way ? 1 : -1);
        if (k < 0 || m < 0 || k == m || done_[at(k)] || done_[at(m)]) break;
        const auto& mates = segment(k).mates;
        if (std::find(mates.begin(), mates.end(), m) == mates.end() || along(k, m) != same_way) break;
        take(k, m);
        run.last_a = k;
        run.last_b = m;
      }
      return run;
    }
    return std::nullopt;
  }

  const BoundarySegment& segment(int i) const { return segments_[at(i)]; }
  int count() const { return static_cast<int>(segments_.size()); }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void take(int a, int b) { done_[at(a)] = done_[at(b)] = true; }
  int welded(int panel, int vertex) const { return garment_.welded[at(panel)](vertex); }

  bool along(int i, int j) const {
    return welded(segment(i).panel, segment(i).from) == welded(segment(j).panel, segment(j).from);
  }

  // The segment after or before `i` on the same edge; -1 at its end.
  int step(int i, int way) const {
    const int next = i + way;
    if (next < 0 || next >= count()) return -1;
    const BoundarySegment &here = segment(i), &there = segment(next);
    const bool joined = way > 0 ? here.to == there.from : here.from == there.to;
    return here.panel == there.panel && here.edge == there.edge && joined ? next : -1;
  }

  const GarmentMesh& garment_;
  std::vector<BoundarySegment> segments_;
  std::vector<bool> done_;
};

}  // namespace

std::vector<int> joined_where_near(const Eigen::Matrix3Xd& positions, const std::vector<int>& where, double near) {
  const auto cell_of = [&](int v) {
    Cell cell;
    for (int k = 0; k < 3; ++k)
      cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(positions(k, v) / near));
    return cell;
  };
  std::vector<int> into(static_cast<std::size_t>(positions.cols()));
  std::iota(into.begin(), into.end(), 0);
  std::map<Cell, std::vector<int>> cells;
  for (const int v : where) {
    const Cell cell = cell_of(v);
    int nearest = -1;
    double distance = near;
    for (std::int64_t x = -1; x <= 1; ++x)
      for (std::int64_t y = -1; y <= 1; ++y)
        for (std::int64_t z = -1; z <= 1; ++z)
          if (const auto found = cells.find({cell[0] + x, cell[1] + y, cell[2] + z}); found != cells.end())
            for (const int other : found->second)
              if (const double far = (positions.col(v) - positions.col(other)).norm(); far <= distance)
                nearest = other, distance = far;
    if (nearest >= 0)
      into[static_cast<std::size_t>(v)] = nearest;
    else
      cells[cell].push_back(v);
  }
  std::vector<int> number(into.size(), -1);
  int next = 0;
  for (std::size_t v = 0; v < into.size(); ++v) {
    int& joined = number[static_cast<std::size_t>(into[v])];
    if (joined < 0) joined = next++;
    number[v] = joined;
  }
  return number;
}

std::vector<Seam> welded_seams_of(const GarmentMesh& garment, const Pattern& pattern, const std::string& place,
                                  Report& report) {
  Runs runs(garment);
  const auto span = [&](const BoundarySegment& segment, double begin, double end) {
    const PanelMesh& panel = garment.panels[static_cast<std::size_t>(segment.panel)];
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    return EdgeSpan{piece.name, panel.copy, piece.outline[static_cast<std::size_t>(segment.edge)].id, at_end(begin),
                    at_end(end)};
  };
  const auto words = [&](const BoundarySegment& segment) {
    const PanelMesh& panel = garment.panels[static_cast<std::size_t>(segment.panel)];
    return panel.name + ".e" + std::to_string(segment.edge);
  };
  std::vector<Seam> seams;
  std::set<std::string> layered;
  for (int i = 0; i < runs.count(); ++i) {
    if (runs.segment(i).mates.size() > 1)
      layered.insert(
          pattern.pieces[static_cast<std::size_t>(garment.panels[static_cast<std::size_t>(runs.segment(i).panel)].piece)].name);
    const auto run = runs.from(i);
    if (!run) continue;
    const BoundarySegment &a = runs.segment(run->first_a), &a_last = runs.segment(run->last_a);
    const BoundarySegment &b = runs.segment(run->first_b), &b_last = runs.segment(run->last_b);
    Seam seam;
    seam.name = words(a) + " to " + words(b);
    seam.a = span(a, a.begin, a_last.end);
    seam.b = run->same_way ? span(b, b.begin, b_last.end) : span(b, b.end, b_last.begin);
    seam.right_to_wrong = run->same_way;
    seams.push_back(std::move(seam));
  }
  if (!layered.empty()) {
    std::string names;
    for (const std::string& name : layered) names += (names.empty() ? "'" : ", '") + name + "'";
    report.warn("obj.three-layers", place,
                "more than two outlines meet along seams of " + names + "; two of them are sewn there",
                "Export one layer of cloth, or write the seams to a sidecar");
  }
  return seams;
}

}  // namespace toile
