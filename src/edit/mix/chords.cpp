#include "edit/mix/chords.h"

#include <algorithm>

#include "geometry/plane_segments.h"

namespace toile {
namespace {

struct LocalCrossing {
  int before = 0, beyond = 0;  // panel vertices
  Eigen::Vector2d at, beyond_at;
};

class Panels {
 public:
  explicit Panels(const GarmentMesh& garment) : garment_(garment), offsets_(triangle_offsets(garment)) {}

  int of(int triangle) const {
    return static_cast<int>(std::upper_bound(offsets_.begin(), offsets_.end(), triangle) - offsets_.begin()) - 1;
  }
  LocalCrossing local(const Crossing& crossing, int triangle) const {
    const PanelMesh& panel = garment_.panels[static_cast<std::size_t>(of(triangle))];
    const auto vertex = [&](int garment_vertex) {
      for (int corner = 0; corner < 3; ++corner)
        if (garment_.triangles(corner, triangle) == garment_vertex)
          return panel.triangles(corner, triangle - offsets_[static_cast<std::size_t>(of(triangle))]);
      return -1;
    };
    LocalCrossing local{vertex(crossing.before), vertex(crossing.beyond), {}, {}};
    const auto drawn = [&](int v) {
      Eigen::Vector2d p = panel.rest.col(v);
      if (panel.mirrored) p.x() = -p.x();
      return p;
    };
    local.beyond_at = drawn(local.beyond);
    local.at = (1 - crossing.at) * drawn(local.before) + crossing.at * local.beyond_at;
    return local;
  }

 private:
  const GarmentMesh& garment_;
  std::vector<int> offsets_;
};

}  // namespace

BoundaryPlaces::BoundaryPlaces(const GarmentMesh& garment) : edges_(garment.panels.size()) {
  for (const BoundarySegment& s : boundary_segments(garment))
    edges_[static_cast<std::size_t>(s.panel)][{s.from, s.to}] = {OutlinePlace{s.edge, s.begin}, s.end};
}

std::optional<OutlinePlace> BoundaryPlaces::find(int panel, int from, int to, double at) const {
  const auto& edges = edges_[static_cast<std::size_t>(panel)];
  auto found = edges.find({from, to});
  if (found == edges.end()) {
    found = edges.find({to, from});
    at = 1 - at;
  }
  if (found == edges.end()) return std::nullopt;
  const auto& [begin, end] = found->second;
  return OutlinePlace{begin.edge, begin.at + at * (end - begin.at)};
}

std::vector<PanelChord> chords_of(const GarmentMesh& garment, const BoundaryPlaces& places, const CutLine& line, int loop,
                                  const std::string& place) {
  const Panels panels(garment);
  const std::size_t n = line.size();
  const auto entered = [&](std::size_t i) { return line[(i + n - 1) % n].triangle; };
  const auto at_seam = [&](std::size_t i) {
    const LocalCrossing a = panels.local(line[i % n], entered(i % n)), b = panels.local(line[i % n], line[i % n].triangle);
    return panels.of(entered(i % n)) != panels.of(line[i % n].triangle) || a.before != b.before || a.beyond != b.beyond;
  };
  std::size_t first = 0;
  while (first < n && !at_seam(first)) ++first;
  if (first == n)
    throw BadInput({"edit.cut-inside-panel", Severity::error, place, "the line runs inside one panel and crosses no seam",
                    "choose a line that goes round a limb through seams"});
  std::vector<PanelChord> chords;
  for (std::size_t i = first; i < first + n;) {
    const int panel = panels.of(line[i % n].triangle);
    PanelChord cut{panel, {}};
    cut.chord.loop = loop;
    cut.chord.rank = static_cast<int>(chords.size());
    std::vector<LocalCrossing> run{panels.local(line[i % n], line[i % n].triangle)};
    std::size_t k = i + 1;
    for (;; ++k) {
      run.push_back(panels.local(line[k % n], entered(k % n)));
      if (at_seam(k % n)) break;
    }
    const auto outline_place = [&](const LocalCrossing& c, const Crossing& crossing) {
      return places.find(panel, c.before, c.beyond, crossing.at).value_or(OutlinePlace{-1, 0});
    };
    cut.chord.from = outline_place(run.front(), line[i % n]);
    cut.chord.to = outline_place(run.back(), line[k % n]);
    double left = 0;
    for (std::size_t j = 0; j < run.size(); ++j) {
      const Eigen::Vector2d way = run[std::min(j + 1, run.size() - 1)].at - run[j > 0 ? j - 1 : 0].at;
      left += cross(way, run[j].beyond_at - run[j].at);
      if (cut.chord.points.empty() || (run[j].at - cut.chord.points.back()).norm() > 1e-9)
        cut.chord.points.push_back(run[j].at);
    }
    cut.chord.beyond_left = left > 0;
    chords.push_back(std::move(cut));
    i = k;
  }
  return chords;
}

}  // namespace toile
