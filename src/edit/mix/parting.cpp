#include "edit/mix/parting.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>

#include "edit/edge_chain.h"
#include "edit/mix/chords.h"
#include "edit/mix/limb_curve.h"
#include "geometry/polyline.h"
#include "geometry/topology.h"

namespace toile {
namespace {

class Groups {
 public:
  explicit Groups(int count) : parent_(static_cast<std::size_t>(count)) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int i) {
    while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
    return i;
  }
  void join(int a, int b) {
    a = of(a);
    b = of(b);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

std::pair<int, int> sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

[[noreturn]] void not_parted(const std::string& place) {
  throw BadInput({"edit.not-parted", Severity::error, place, "the garment is still in one part when it is cut along that loop",
                  "choose a loop that goes all the way round, or name every loop that has to be cut"});
}

// By mesh edge and its direction: triangles on its left, several where several pieces are sewn into one seam.
using LeftOf = std::multimap<std::pair<int, int>, int>;

// The two sides of a seam, as triangles: on the left of the loop as it runs, and on the right.
struct SeamSides {
  std::vector<int> left, right;
};

SeamSides sides_of(const VertexLoop& loop, const LeftOf& left_of) {
  SeamSides sides;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i], b = loop[(i + 1) % loop.size()];
    for (auto [at, end] = left_of.equal_range({a, b}); at != end; ++at) sides.left.push_back(at->second);
    for (auto [at, end] = left_of.equal_range({b, a}); at != end; ++at) sides.right.push_back(at->second);
  }
  return sides;
}

// Groups of triangles that are beyond the loops.
std::set<int> groups_beyond_seams(const EditInput& input, const std::vector<CutLoop>& loops, Groups& groups,
                                  const LeftOf& left_of, const std::string& place) {
  const auto axes = trunk_and_limbs(input.body.form);
  std::set<int> beyond, before;
  for (const CutLoop& loop : loops) {
    if (loop.seam.empty()) continue;
    const auto points = points_of(loop.seam, input.drape);
    const auto limb = limb_inside(input.body, axes, points);
    const auto along = [&](const Eigen::Vector3d& at) {
      return limb_place(input.body, axes[static_cast<std::size_t>(limb)], limb, at).along;
    };
    const auto mean = [&](const std::vector<int>& triangles) {
      double sum = 0;
      for (const int t : triangles)
        sum += along((input.drape.col(input.garment.triangles(0, t)) + input.drape.col(input.garment.triangles(1, t)) +
                      input.drape.col(input.garment.triangles(2, t))) /
                     3);
      return sum / static_cast<double>(triangles.size());
    };
    double own = 0;
    for (const Eigen::Vector3d& point : points) own += along(point) / static_cast<double>(points.size());
    const SeamSides sides = sides_of(loop.seam, left_of);
    const double left = sides.left.empty() ? own : mean(sides.left), right = sides.right.empty() ? own : mean(sides.right);
    for (const int t : sides.left) (left > right ? beyond : before).insert(groups.of(t));
    for (const int t : sides.right) (left > right ? before : beyond).insert(groups.of(t));
  }
  for (const int group : beyond)
    if (before.count(group)) not_parted(place);
  return beyond;
}

}  // namespace

Parting part_garment(const EditInput& input, const std::vector<CutLoop>& loops, const std::string& place) {
  const GarmentMesh& garment = input.garment;
  const Eigen::Matrix3Xi& triangles = garment.triangles;
  Parting parting;
  parting.loops = loops;
  parting.panels.resize(garment.panels.size());
  std::set<std::pair<int, int>> cut;  // mesh edges that lines cross or seams run along
  std::vector<bool> across(static_cast<std::size_t>(triangles.cols()), false);
  for (const CutLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.seam.size(); ++i) cut.insert(sorted(loop.seam[i], loop.seam[(i + 1) % loop.seam.size()]));
    for (const Crossing& c : loop.line) {
      cut.insert(sorted(c.before, c.beyond));
      across[static_cast<std::size_t>(c.triangle)] = true;
    }
  }
  // Triangles that no line crosses, in groups that hang together.
  Groups groups(static_cast<int>(triangles.cols()));
  LeftOf left_of;
  for (const MeshEdge& edge : mesh_edges(triangles)) {
    const int a = edge.triangle[0], b = edge.triangle[1];
    if (b < 0 || across[static_cast<std::size_t>(a)] || across[static_cast<std::size_t>(b)]) continue;
    if (!cut.count(sorted(edge.vertex[0], edge.vertex[1]))) groups.join(a, b);
  }
  std::vector<std::vector<int>> round(static_cast<std::size_t>(garment.vertex_count));
  for (int t = 0; t < static_cast<int>(triangles.cols()); ++t)
    for (int corner = 0; corner < 3; ++corner) {
      left_of.emplace(std::pair(triangles(corner, t), triangles((corner + 1) % 3, t)), t);
      round[static_cast<std::size_t>(triangles(corner, t))].push_back(t);
    }
  std::set<int> beyond = groups_beyond_seams(input, loops, groups, left_of, place), before;
  for (const CutLoop& loop : loops)
    for (const Crossing& c : loop.line) {
      for (const int t : round[static_cast<std::size_t>(c.beyond)])
        if (!across[static_cast<std::size_t>(t)]) beyond.insert(groups.of(t));
      for (const int t : round[static_cast<std::size_t>(c.before)])
        if (!across[static_cast<std::size_t>(t)]) before.insert(groups.of(t));
    }
  for (const int group : beyond)
    if (before.count(group)) not_parted(place);

  const BoundaryPlaces places(garment);
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (loops[i].line.empty()) continue;
    for (PanelChord& chord : chords_of(garment, places, loops[i].line, static_cast<int>(i), place))
      parting.panels[static_cast<std::size_t>(chord.panel)].chords.push_back(std::move(chord.chord));
  }
  const std::vector<int> offsets = triangle_offsets(garment);
  for (std::size_t p = 0; p < garment.panels.size(); ++p)
    if (parting.panels[p].chords.empty()) parting.panels[p].beyond = beyond.count(groups.of(offsets[p])) > 0;
  return parting;
}

namespace {

// The edges of a piece between two places of its outline, going on from `from`; and how far their points are from `points`.
struct OutlineRun {
  std::vector<int> edges;  // whole ones
  double far = 0;
};

OutlineRun run_between(const Piece& piece, const OutlinePlace& from, const OutlinePlace& to,
                       const std::vector<Eigen::Vector2d>& points) {
  const auto count = static_cast<int>(piece.outline.size());
  OutlineRun run;
  const auto look = [&](const Eigen::Vector2d& at) { run.far = std::max(run.far, nearest_on<2>(points, at).distance); };
  const bool same = from.edge == to.edge && to.at >= from.at;
  for (int e = from.edge; !same;) {
    e = (e + 1) % count;
    look(piece.outline[static_cast<std::size_t>(e)].points.front().at);
    if (e == to.edge) break;
    for (const OutlinePoint& point : piece.outline[static_cast<std::size_t>(e)].points) look(point.at);
    run.edges.push_back(e);
  }
  return run;
}

// The seam beside a line, when there is one all the way round.
std::optional<VertexLoop> seam_beside(const EditInput& input, const std::vector<PanelChord>& chords, bool beyond, double near,
                                      const std::string& place) {
  std::vector<PanelEdge> edges;
  for (const auto& [panel, chord] : chords) {
    const Piece& piece =
        input.pattern.pieces[static_cast<std::size_t>(input.garment.panels[static_cast<std::size_t>(panel)].piece)];
    // The outline runs counter-clockwise: what is left of the chord is passed on the way from its end to its start.
    const OutlineRun run = chord.beyond_left == beyond ? run_between(piece, chord.to, chord.from, chord.points)
                                                       : run_between(piece, chord.from, chord.to, chord.points);
    if (run.far > near) return std::nullopt;
    for (const int e : run.edges) edges.push_back({panel, e});
  }
  try {
    const auto loops = closed_chains(input.pattern, input.garment, input.drape, edges, place, "line");
    if (loops.size() == 1) return loops.front();
  } catch (const BadInput&) {
  }
  return std::nullopt;
}

// The seam that a line runs along and crosses, never further from it than `near` (m): a line there would leave slivers of
// pieces on both sides.
std::optional<VertexLoop> seam_crossed(const EditInput& input, const CutLine& line, const std::vector<PanelChord>& chords,
                                       double near, const std::string& place) {
  std::vector<Eigen::Vector3d> points = points_of(line, input.drape);
  points.push_back(points.front());
  std::vector<PanelEdge> edges;
  bool crosses = false;
  for (int p = 0; p < static_cast<int>(input.garment.panels.size()); ++p) {
    const int piece = input.garment.panels[static_cast<std::size_t>(p)].piece;
    for (int e = 0; e < static_cast<int>(input.pattern.pieces[static_cast<std::size_t>(piece)].outline.size()); ++e) {
      const std::vector<int> along = vertices_along(input.pattern, input.garment, {p, e});
      if (std::any_of(along.begin(), along.end(),
                      [&](int v) { return nearest_on<3>(points, input.drape.col(v)).distance > near; }))
        continue;
      edges.push_back({p, e});
      crosses = crosses || std::any_of(chords.begin(), chords.end(), [&](const PanelChord& c) {
                  return c.panel == p && (c.chord.from.edge == e || c.chord.to.edge == e);
                });
    }
  }
  if (!crosses) return std::nullopt;
  try {
    const auto loops = closed_chains(input.pattern, input.garment, input.drape, edges, place, "line");
    if (loops.size() != 1) return std::nullopt;
    std::vector<Eigen::Vector3d> seam = points_of(loops.front(), input.drape);
    seam.push_back(seam.front());
    if (std::all_of(points.begin(), points.end(),
                    [&](const Eigen::Vector3d& at) { return nearest_on<3>(seam, at).distance <= near; }))
      return loops.front();
  } catch (const BadInput&) {
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> sliver(const EditInput& input, const CutLoop& loop, const std::string& place) {
  constexpr double least = 4e-4;  // m^2
  if (loop.line.empty()) return std::nullopt;
  for (const auto& [panel, chord] : chords_of(input.garment, BoundaryPlaces(input.garment), loop.line, 0, place)) {
    if (chord.from.edge != chord.to.edge) continue;
    double twice = 0;
    for (std::size_t i = 0; i < chord.points.size(); ++i) {
      const Eigen::Vector2d &a = chord.points[i], &b = chord.points[(i + 1) % chord.points.size()];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    if (std::abs(twice) / 2 < least) return input.garment.panels[static_cast<std::size_t>(panel)].name;
  }
  return std::nullopt;
}

std::vector<CutLoop> moved_to_seams(const EditInput& input, const std::vector<CutLoop>& loops, double near,
                                    const std::string& place) {
  const BoundaryPlaces places(input.garment);
  std::vector<CutLoop> moved = loops;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (!moved[i].seam.empty()) continue;
    const auto chords = chords_of(input.garment, places, moved[i].line, static_cast<int>(i), place);
    for (const bool beyond : {false, true})
      if (const auto seam = seam_beside(input, chords, beyond, near, place)) {
        moved[i] = {*seam, {}};
        break;
      }
    if (!moved[i].seam.empty()) continue;
    if (const auto seam = seam_crossed(input, moved[i].line, chords, 3 * near, place)) moved[i] = {*seam, {}};
  }
  return moved;
}

}  // namespace toile
