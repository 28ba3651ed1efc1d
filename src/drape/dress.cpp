#include "drape/dress.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "drape/placement.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double time_step = 1.0 / 120;  // s
constexpr double speed_kept = 0.92;      // per step
constexpr double longest_move = 5e-3;    // m per step
constexpr double compression_share = 0.6;
constexpr double bending_share = 0.05;

struct Tie {
  int a, b;
  double length;
};

// Loose panels, one vertex per panel vertex, numbered panel after panel.
struct LooseCloth {
  Eigen::Matrix3Xd x;
  std::vector<int> garment_vertex;
  std::vector<int> panel;
  std::vector<Tie> edges;
  std::vector<Tie> bends;                  // corners off an inner edge
  std::vector<std::vector<int>> stitched;  // vertices that become one
  std::vector<double> stitch_length;       // at the start, by vertex: distance to the middle of its stitch
};

LooseCloth loose_cloth(const Pattern& pattern, const GarmentMesh& garment, const Body& body) {
  LooseCloth cloth;
  const auto placed = place_panels(pattern, garment, body);
  int count = 0;
  for (const auto& positions : placed) count += static_cast<int>(positions.cols());
  cloth.x.resize(3, count);
  std::vector<std::vector<int>> members(static_cast<std::size_t>(garment.vertex_count));
  int first = 0;
  for (std::size_t p = 0; p < placed.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const auto n = static_cast<int>(placed[p].cols());
    cloth.x.middleCols(first, n) = placed[p];
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
    first += n;
  }
  cloth.stitch_length.assign(static_cast<std::size_t>(count), 0.0);
  for (auto& group : members) {
    if (group.size() < 2) continue;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : group) middle += cloth.x.col(v);
    middle /= static_cast<double>(group.size());
    for (const int v : group) cloth.stitch_length[static_cast<std::size_t>(v)] = (cloth.x.col(v) - middle).norm();
    cloth.stitched.push_back(std::move(group));
  }
  return cloth;
}

void hold_length(Eigen::Matrix3Xd& x, const Tie& tie, double stretch_share, double squash_share) {
  const Eigen::Vector3d apart = x.col(tie.b) - x.col(tie.a);
  const double length = apart.norm();
  if (length < 1e-12) return;
  const double share = length > tie.length ? stretch_share : squash_share;
  const Eigen::Vector3d move = share / 2 * (1 - tie.length / length) * apart;
  x.col(tie.a) += move;
  x.col(tie.b) -= move;
}

// Brings every stitched vertex to within `open` of its starting distance from the stitch's middle.
void pull_stitches(const LooseCloth& cloth, double open, Eigen::Matrix3Xd& x) {
  for (const auto& group : cloth.stitched) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const int v : group) middle += x.col(v);
    middle /= static_cast<double>(group.size());
    for (const int v : group) {
      const Eigen::Vector3d apart = x.col(v) - middle;
      const double length = apart.norm();
      const double allowed = open * cloth.stitch_length[static_cast<std::size_t>(v)];
      if (length > allowed) x.col(v) -= (1 - allowed / length) * apart;
    }
  }
}

void push_out(const Body& body, double offset, Eigen::Matrix3Xd& x) {
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    if (body.distance.distance(x.col(v)) >= offset) continue;
    const DistanceSample sample = body.distance.sample(x.col(v));
    const double steepness = sample.gradient.squaredNorm();
    if (steepness > 1e-6) x.col(v) += std::min(offset - sample.distance, 0.02) / steepness * sample.gradient;
  }
}

double widest_gap(const LooseCloth& cloth, const Eigen::Matrix3Xd& x, const GarmentMesh& garment, std::string& where) {
  double widest = -1;
  for (const auto& group : cloth.stitched)
    for (const int v : group) {
      const double gap = (x.col(v) - x.col(group.front())).norm();
      if (gap <= widest) continue;
      widest = gap;
      const auto name = [&](int vertex) {
        return garment.panels[static_cast<std::size_t>(cloth.panel[static_cast<std::size_t>(vertex)])].name;
      };
      where = "seam between '" + name(group.front()) + "' and '" + name(v) + "'";
    }
  return std::max(widest, 0.0);
}

// Turns of a closed loop of vertices round the vertical line through the middle of the body's trunk at its height.
double turns_round_trunk(const std::vector<int>& loop, const Eigen::Matrix3Xd& x, const Body& body) {
  double height = 0;
  for (const int v : loop) height += x(1, v) / static_cast<double>(loop.size());
  double low = 1e9;
  double high = -1e9;
  for (Eigen::Index v = 0; v < body.form.positions.cols(); ++v)
    if (std::abs(body.form.positions(1, v) - height) < 0.03) {
      low = std::min(low, body.form.positions(2, v));
      high = std::max(high, body.form.positions(2, v));
    }
  const double z = (low + high) / 2;
  double turned = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = x.col(loop[i]);
    const Eigen::Vector3d b = x.col(loop[(i + 1) % loop.size()]);
    turned += std::atan2(a.x() * (b.z() - z) - (a.z() - z) * b.x(), a.x() * b.x() + (a.z() - z) * (b.z() - z));
  }
  return turned / (2 * std::numbers::pi);
}

// A garment whose every opening lies beside the body is not being worn, however well its seams closed.
void check_worn(const GarmentMesh& garment, const Body& body, Dressed& dressed) {
  const auto loops = boundary_loops(garment.triangles);
  const bool round = std::any_of(loops.begin(), loops.end(), [&](const std::vector<int>& loop) {
    return std::abs(turns_round_trunk(loop, dressed.positions, body)) > 0.5;
  });
  if (!loops.empty() && !round)
    dressed.report.error("drape.not-around-body", "garment", "no opening of the sewn garment goes round the body",
                         "Check where the pieces are placed and which edges are left open", Fault::not_converged);
}

}  // namespace

Dressed dress(const Pattern& pattern, const GarmentMesh& garment, const Body& body, const DressOptions& options) {
  LooseCloth cloth = loose_cloth(pattern, garment, body);
  Eigen::Matrix3Xd& x = cloth.x;
  Eigen::Matrix3Xd velocity = Eigen::Matrix3Xd::Zero(3, x.cols());
  const int steps = options.shrinking_steps + options.holding_steps;
  for (int step = 0; step < steps; ++step) {
    const double t = std::min(1.0, static_cast<double>(step + 1) / options.shrinking_steps);
    const double open = 1 - t * t * (3 - 2 * t);
    const Eigen::Matrix3Xd before = x;
    x += time_step * velocity;
    for (int sweep = 0; sweep < options.sweeps; ++sweep) {
      for (const Tie& edge : cloth.edges) hold_length(x, edge, 1, compression_share);
      for (const Tie& bend : cloth.bends) hold_length(x, bend, bending_share, bending_share);
      push_out(body, options.body_offset, x);
      pull_stitches(cloth, open, x);
    }
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      const Eigen::Vector3d move = x.col(v) - before.col(v);
      const double length = move.norm();
      if (length > longest_move) x.col(v) = before.col(v) + longest_move / length * move;
    }
    velocity = speed_kept / time_step * (x - before);
    if (options.progress) options.progress(step + 1, steps);
  }

  Dressed dressed;
  std::string where;
  dressed.seam_gap = widest_gap(cloth, x, garment, where);
  if (dressed.seam_gap > options.closed_gap)
    dressed.report.error("drape.seam-open", where,
                         "did not come together: " + std::to_string(std::lround(dressed.seam_gap * 1e3)) + " mm are left open",
                         "Check the lengths of the seam and where its pieces are placed", Fault::not_converged);
  dressed.positions = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
  Eigen::VectorXd count = Eigen::VectorXd::Zero(garment.vertex_count);
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const int g = cloth.garment_vertex[static_cast<std::size_t>(v)];
    dressed.positions.col(g) += x.col(v);
    count(g) += 1;
  }
  for (Eigen::Index g = 0; g < count.size(); ++g) dressed.positions.col(g) /= count(g);
  check_worn(garment, body, dressed);
  return dressed;
}

}  // namespace toile
