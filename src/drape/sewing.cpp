#include "drape/sewing.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "collide/truncation.h"
#include "drape/stitches.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr int patience = 30;             // steps in which a gap that is closing gets narrower
constexpr double time_step = 1.0 / 120;  // s
constexpr double speed_kept = 0.92;      // per step
constexpr double longest_move = 5e-3;    // m per step
constexpr double compression_share = 0.6;
constexpr double unfolding_from = 0.75;  // of the shrinking
constexpr double longest_reach = 12e-3;  // m, of the search for cloth that is near to cloth
constexpr double reach_share =
    0.65;                         // of the mean edge, at most: farther, every triangle is near to its neighbours' neighbours
constexpr double margin = 12e-3;  // m, moved before the search begins afresh
constexpr int most_searches = 3;  // per step
constexpr double far_behind = 0.3e-3;  // m; what stays behind by more is searched for anew at once, by less in the next step

void hold_length(Eigen::Matrix3Xd& x, const Tie& tie, double stretch_share, double squash_share) {
  const Eigen::Vector3d apart = x.col(tie.b) - x.col(tie.a);
  const double length = apart.norm();
  if (length < 1e-12) return;
  const double share = length > tie.length ? stretch_share : squash_share;
  const Eigen::Vector3d move = share / 2 * (1 - tie.length / length) * apart;
  x.col(tie.a) += move;
  x.col(tie.b) -= move;
}

// Where cloth can meet the body in this step: vertices, and edges and triangles whose middles are held out as well, because
// flat faces bridge hollows.
struct NearBody {
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> edges;
  std::vector<std::array<int, 3>> triangles;
};

NearBody near_body(const Body& body, const LoosePanels& cloth, const Eigen::Matrix3Xd& x) {
  NearBody near;
  std::vector<char> is_near(static_cast<std::size_t>(x.cols()), 0);
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    if (body.distance.distance(x.col(v)) < 4 * longest_move) {
      near.vertices.push_back(static_cast<int>(v));
      is_near[static_cast<std::size_t>(v)] = 1;
    }
  const auto all_near = [&](const auto& corners) {
    return std::all_of(corners.begin(), corners.end(), [&](int v) { return is_near[static_cast<std::size_t>(v)] != 0; });
  };
  for (const Tie& edge : cloth.edges)
    if (const std::array<int, 2> ends{edge.a, edge.b}; all_near(ends)) near.edges.push_back(ends);
  for (Eigen::Index t = 0; t < cloth.triangles.cols(); ++t) {
    const std::array<int, 3> corners{cloth.triangles(0, t), cloth.triangles(1, t), cloth.triangles(2, t)};
    if (all_near(corners)) near.triangles.push_back(corners);
  }
  return near;
}

// Moves all `corners` alike until their middle is `offset` outside.
template <class Corners>
void push_middle_out(const Body& body, double offset, const Corners& corners, Eigen::Matrix3Xd& x) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int v : corners) middle += x.col(v) / static_cast<double>(corners.size());
  if (body.distance.distance(middle) >= offset) return;
  const DistanceSample sample = body.distance.sample(middle);
  const double steepness = sample.gradient.squaredNorm();
  if (steepness <= 1e-6) return;
  const Eigen::Vector3d out = std::min(offset - sample.distance, 0.02) / steepness * sample.gradient;
  for (const int v : corners) x.col(v) += out;
}

void push_out(const Body& body, double offset, const NearBody& near, bool middles, Eigen::Matrix3Xd& x) {
  for (const int v : near.vertices) push_middle_out(body, offset, std::array<int, 1>{v}, x);
  if (!middles) return;
  for (const auto& ends : near.edges) push_middle_out(body, offset, ends, x);
  for (const auto& corners : near.triangles) push_middle_out(body, offset, corners, x);
}

// Keeps two layers `thickness` apart along the normal they had when they were found.
void part_layers(const std::vector<NearPair>& pairs, double thickness, Eigen::Matrix3Xd& x) {
  for (const NearPair& pair : pairs) {
    double apart = 0;
    double inertia = 0;
    for (int i = 0; i < 4; ++i) {
      const double side = i < pair.first ? pair.weight(i) : -pair.weight(i);
      apart += side * pair.normal.dot(x.col(pair.vertex[static_cast<std::size_t>(i)]));
      inertia += side * side;
    }
    if (apart >= thickness) continue;
    for (int i = 0; i < 4; ++i) {
      const double side = i < pair.first ? pair.weight(i) : -pair.weight(i);
      x.col(pair.vertex[static_cast<std::size_t>(i)]) += (thickness - apart) / inertia * side * pair.normal;
    }
  }
}

// Moves a cloth without letting it pass through itself; looks for near pairs anew when the last ones are in the way.
class Mover {
 public:
  explicit Mover(const LoosePanels& cloth) : search_(search_of(cloth)) {}

  void move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& to) {
    for (int search = 0; search <= most_searches; ++search) {
      if (search > 0) near_.emplace(x, search_);
      behind_ = near_->advance(x, to);
      if (behind_ < far_behind) return;
    }
  }
  const std::vector<NearPair>& pairs(const Eigen::Matrix3Xd& x) {
    if (!near_ || behind_ > 0) near_.emplace(x, search_);
    return near_->pairs();
  }

 private:
  static NearPairSearch search_of(const LoosePanels& cloth) {
    double sum = 0;
    for (const Tie& edge : cloth.edges) sum += edge.length;
    const double reach = std::min(longest_reach, reach_share * sum / static_cast<double>(cloth.edges.size()));
    return {collision_mesh(cloth.triangles, static_cast<int>(cloth.positions.cols()), cloth.garment_vertex), reach, margin};
  }

  NearPairSearch search_;
  std::optional<Truncation> near_;
  double behind_ = 0;
};

double smooth_step(double t) { return t * t * (3 - 2 * t); }

// The cloth's edges on their way from the lengths they start with to those they are cut with.
class Unfolding {
 public:
  Unfolding(const LoosePanels& cloth, bool from_start) : cut_edges_(&cloth.edges), cut_bends_(&cloth.bends) {
    for (auto [cut, start] : {std::pair{cut_edges_, &start_edges_}, std::pair{cut_bends_, &start_bends_}})
      for (const Tie& tie : *cut)
        start->push_back(from_start ? (cloth.positions.col(tie.b) - cloth.positions.col(tie.a)).norm() : tie.length);
    edges = cloth.edges;
    bends = cloth.bends;
  }

  void go_to(double share) {
    for (std::size_t i = 0; i < edges.size(); ++i) edges[i].length = std::lerp(start_edges_[i], (*cut_edges_)[i].length, share);
    for (std::size_t i = 0; i < bends.size(); ++i) bends[i].length = std::lerp(start_bends_[i], (*cut_bends_)[i].length, share);
  }

  std::vector<Tie> edges, bends;

 private:
  const std::vector<Tie>*cut_edges_, *cut_bends_;
  std::vector<double> start_edges_, start_bends_;
};

double widest(const std::vector<double>& gaps) { return gaps.empty() ? 0 : *std::max_element(gaps.begin(), gaps.end()); }

}  // namespace

LoosePanels loose_panels(const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& placed) {
  LoosePanels cloth;
  int count = 0;
  for (const auto& positions : placed) count += static_cast<int>(positions.cols());
  cloth.positions.resize(3, count);
  cloth.triangles.resize(3, garment.triangles.cols());
  std::vector<std::vector<int>> members(static_cast<std::size_t>(garment.vertex_count));
  int first = 0;
  Eigen::Index triangle = 0;
  for (std::size_t p = 0; p < placed.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const auto n = static_cast<int>(placed[p].cols());
    cloth.first.push_back(first);
    cloth.positions.middleCols(first, n) = placed[p];
    cloth.triangles.middleCols(triangle, panel.triangles.cols()) = panel.triangles.array() + first;
    for (int v = 0; v < n; ++v) {
      cloth.garment_vertex.push_back(garment.welded[p](v));
      cloth.panel.push_back(static_cast<int>(p));
      members[static_cast<std::size_t>(garment.welded[p](v))].push_back(first + v);
    }
    const auto tie = [&](int a, int b) { return Tie{first + a, first + b, (panel.rest.col(a) - panel.rest.col(b)).norm()}; };
    for (const MeshEdge& edge : mesh_edges(panel.triangles)) {
      cloth.edges.push_back(tie(edge.vertex[0], edge.vertex[1]));
      if (edge.triangle[1] < 0) continue;
      cloth.bends.push_back(tie(edge.opposite[0], edge.opposite[1]));
    }
    triangle += panel.triangles.cols();
    first += n;
  }
  for (auto& group : members)
    if (group.size() > 1) cloth.stitched.push_back(std::move(group));
  return cloth;
}

std::vector<double> stitch_gaps(const LoosePanels& cloth) {
  std::vector<double> gaps;
  for (const auto& group : cloth.stitched) {
    double gap = 0;
    for (std::size_t i = 0; i < group.size(); ++i)
      for (std::size_t j = i + 1; j < group.size(); ++j)
        gap = std::max(gap, (cloth.positions.col(group[i]) - cloth.positions.col(group[j])).norm());
    gaps.push_back(gap);
  }
  return gaps;
}

void draw_together(const SewOptions& options, const Body& body, LoosePanels& cloth) {
  Eigen::Matrix3Xd& x = cloth.positions;
  Stitches stitches(cloth, options.shrinking_steps);
  Mover mover(cloth);
  Unfolding ties(cloth, options.unfold);
  Eigen::Matrix3Xd velocity = Eigen::Matrix3Xd::Zero(3, x.cols());
  const int steps = stitches.layers() * options.shrinking_steps + options.holding_steps;
  double gap = 0;
  double gap_before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < steps + options.longest_hold; ++step) {
    if (step >= steps && gap <= options.closed_gap / 4) break;
    if (step >= steps && (step - steps) % patience == 0) {
      if (gap > 0.7 * gap_before) break;  // stuck
      gap_before = gap;
    }
    stitches.begin(step, x);
    const double t = stitches.outermost() ? stitches.share() : 0;
    if (options.unfold) ties.go_to(smooth_step(std::max(0.0, (t - unfolding_from) / (1 - unfolding_from))));
    const Eigen::Matrix3Xd before = x;
    const auto& pairs = mover.pairs(x);
    const NearBody near = near_body(body, cloth, x);
    Eigen::Matrix3Xd to = x + time_step * velocity;
    for (int sweep = 0; sweep < options.sweeps; ++sweep) {
      for (const Tie& edge : ties.edges) hold_length(to, edge, 1, compression_share);
      for (const Tie& bend : ties.bends) hold_length(to, bend, options.bending_share, options.bending_share);
      part_layers(pairs, options.thickness, to);
      push_out(body, options.body_offset, near, (options.sweeps - sweep) % 4 == 1, to);
      stitches.pull(to);
    }
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      const Eigen::Vector3d move = to.col(v) - before.col(v);
      const double length = move.norm();
      if (length > longest_move) to.col(v) = before.col(v) + longest_move / length * move;
    }
    mover.move(x, to);
    velocity = speed_kept / time_step * (x - before);
    if (step + 1 >= steps) gap = widest(stitch_gaps(cloth));
    if (options.progress) options.progress(std::min(step + 1, steps), steps);
  }
}

}  // namespace toile
