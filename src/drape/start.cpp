#include "drape/start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "collide/intersections.h"
#include "collide/near_pairs.h"
#include "drape/limb_panels.h"
#include "drape/placement.h"

namespace toile {
namespace {

constexpr double clearance = 0.01;  // m, between a flat panel and the body
constexpr double step = 0.01;       // m
constexpr double most_lift = 0.15;  // m
constexpr double touching = 1e-3;   // m

const Placement* placement_of(const Pattern& pattern, const PanelMesh& panel) {
  const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
  const auto copy = static_cast<std::size_t>(panel.copy - 1);
  return copy < piece.placement.size() && piece.placement[copy] ? &*piece.placement[copy] : nullptr;
}

double least_distance(const Body& body, const Eigen::Matrix3Xd& x) {
  double least = 1e9;
  for (Eigen::Index v = 0; v < x.cols(); ++v) least = std::min(least, body.distance.distance(x.col(v)));
  return least;
}

// Straight out, the way its right side faces, until it is clear of the body.
void move_clear(const Body& body, const Eigen::Vector3d& outside, Eigen::Matrix3Xd& x) {
  for (double moved = 0; moved < 0.3 && least_distance(body, x) < clearance; moved += step) x.colwise() += step * outside;
}

int blocked_stitches(const LoosePanels& cloth, const Body& body) {
  int blocked = 0;
  for (const auto& group : cloth.stitched)
    for (std::size_t i = 1; i < group.size(); ++i) {
      const Eigen::Vector3d from = cloth.positions.col(group[0]);
      const Eigen::Vector3d to = cloth.positions.col(group[i]);
      if (!body.skin.crossings(from, to - from).empty()) ++blocked;
    }
  return blocked;
}

// Panels that lie in one plane and touch are moved apart along their right sides.
void part_touching(const GarmentMesh& garment, const std::vector<Eigen::Vector3d>& outside,
                   std::vector<Eigen::Matrix3Xd>& placed) {
  for (int attempt = 0; attempt < 8; ++attempt) {
    const LoosePanels cloth = loose_panels(garment, placed);
    const auto mesh = collision_mesh(cloth.triangles, static_cast<int>(cloth.positions.cols()), cloth.garment_vertex);
    std::vector<char> moves(placed.size(), 0);
    const auto apart = [&](int a, int b) {
      const int first = std::min(cloth.panel[static_cast<std::size_t>(a)], cloth.panel[static_cast<std::size_t>(b)]);
      const int second = std::max(cloth.panel[static_cast<std::size_t>(a)], cloth.panel[static_cast<std::size_t>(b)]);
      if (first != second && !moves[static_cast<std::size_t>(first)]) moves[static_cast<std::size_t>(second)] = 1;
    };
    for (const NearPair& pair : near_pairs(cloth.positions, mesh, touching)) apart(pair.vertex[0], pair.vertex[3]);
    for (const auto& [a, b] : intersecting_triangles(cloth.positions, cloth.triangles))
      apart(cloth.triangles(0, a), cloth.triangles(0, b));
    bool any = false;
    for (std::size_t p = 0; p < placed.size(); ++p)
      if (moves[p]) {
        placed[p].colwise() += step * outside[p];
        any = true;
      }
    if (!any) return;
  }
}

}  // namespace

Start start_positions(const Pattern& pattern, const GarmentMesh& garment, const Body& body, double higher) {
  Start start;
  start.placed = place_panels(pattern, garment, body);
  const std::size_t count = garment.panels.size();
  const std::vector<ArmLine> arms = arm_lines(body.form);
  std::vector<char> lifted(count, 0);
  std::vector<Eigen::Vector3d> outside(count, Eigen::Vector3d::Zero());
  std::vector<std::vector<std::size_t>> on_arm(arms.size());
  std::vector<FlatPanel> flat(count);
  for (std::size_t p = 0; p < count; ++p) {
    const Placement* placement = placement_of(pattern, garment.panels[p]);
    if (!placement) continue;
    flat[p] = {start.placed[p], placement->rotation};
    outside[p] = placement->rotation.col(2);
    if (const auto arm = arm_of(flat[p], arms, body.form))
      on_arm[*arm].push_back(p);
    else
      lifted[p] = 1;
  }
  for (std::size_t arm = 0; arm < arms.size(); ++arm) {
    std::vector<FlatPanel> panels;
    for (const std::size_t p : on_arm[arm]) panels.push_back(flat[p]);
    const auto rolled = rolled_round(arms[arm], panels, body);
    for (std::size_t i = 0; i < panels.size(); ++i) start.placed[on_arm[arm][i]] = rolled[i];
    for (const std::size_t p : on_arm[arm]) outside[p] = (arms[arm].wrist - arms[arm].shoulder).normalized();
  }
  if (std::none_of(lifted.begin(), lifted.end(), [](char l) { return l != 0; })) return start;

  const auto raised = [&](double lift) {
    auto placed = start.placed;
    for (std::size_t p = 0; p < count; ++p)
      if (lifted[p]) {
        placed[p].row(1).array() += lift;
        move_clear(body, outside[p], placed[p]);
      }
    return placed;
  };
  int fewest = -1;
  const auto levels = static_cast<int>(std::lround(most_lift / step));
  for (int level = 0; level <= 2 * levels; ++level) {
    const double lift = step * (level % 2 ? (level + 1) / 2 : -level / 2);  // 0, 1, -1, 2, -2, ... cm
    const int blocked = blocked_stitches(loose_panels(garment, raised(lift)), body);
    if (fewest >= 0 && blocked >= fewest) continue;
    fewest = blocked;
    start.lift = lift;
  }
  start.lift += higher;
  start.placed = raised(start.lift);
  part_touching(garment, outside, start.placed);
  const LoosePanels cloth = loose_panels(garment, start.placed);
  start.blocked_stitches = blocked_stitches(cloth, body);
  start.intersections = static_cast<int>(intersecting_triangles(cloth.positions, cloth.triangles).size());
  return start;
}

}  // namespace toile
