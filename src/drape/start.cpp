#include "drape/start.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "body/relative.h"
#include "collide/intersections.h"
#include "collide/near_pairs.h"
#include "drape/flat_layers.h"
#include "drape/layers.h"
#include "drape/limb_panels.h"
#include "drape/placement.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double clearance = 0.01;    // m, between a flat panel and the body
constexpr double step = 0.01;         // m
constexpr double most_lift = 0.15;    // m
constexpr double touching = 1e-3;     // m
constexpr double sleeve_gap = 5e-3;   // m, likewise of sleeves
constexpr double facing_alike = 0.5;  // cosine
constexpr std::array<double, 4> narrower{.7, .5, .3, .15};
constexpr double above_ankle = 0.025;   // of the body's height: over the instep
constexpr double beside_middle = 0.03;  // of the body's height
constexpr double half_trunk = 0.12;     // of the body's height
constexpr double row_gap = 0.1;         // m, between the middles of panels of two rows

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

int outermost(const std::vector<int>& layer) { return layer.empty() ? 0 : *std::max_element(layer.begin(), layer.end()); }

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

// The panels that move, those of about one height together, from the floor up.
std::vector<std::vector<std::size_t>> rows_of(const std::vector<Eigen::Matrix3Xd>& placed, const std::vector<char>& moves) {
  std::vector<std::pair<double, std::size_t>> middles;
  for (std::size_t p = 0; p < placed.size(); ++p)
    if (moves[p]) middles.emplace_back((placed[p].row(1).minCoeff() + placed[p].row(1).maxCoeff()) / 2, p);
  std::sort(middles.begin(), middles.end());
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < middles.size(); ++i) {
    if (i == 0 || middles[i].first - middles[i - 1].first > row_gap) rows.emplace_back();
    rows.back().push_back(middles[i].second);
  }
  return rows;
}

const LimbAxis* left_leg(const std::vector<LimbAxis>& axes) {
  const auto leg = std::find_if(axes.begin(), axes.end(), [](const LimbAxis& axis) { return axis.name == "leg.L"; });
  return leg == axes.end() ? nullptr : &*leg;
}

double knee_height(const Mannequin& form) {
  const std::vector<LimbAxis> axes = limb_axes(form);
  const LimbAxis* leg = left_leg(axes);
  return leg && leg->points.size() > 2 ? leg->points[1].y() : -1e9;
}

double ankle_height(const Mannequin& form) {
  const std::vector<LimbAxis> axes = limb_axes(form);
  const LimbAxis* leg = left_leg(axes);
  return leg ? leg->points.back().y() + above_ankle * form.height : -1e9;
}

// Does some edge of the garment go round one leg, below the knee? By where its panels are placed.
bool has_legs(const GarmentMesh& garment, const std::vector<Eigen::Matrix3Xd>& placed, const Mannequin& form) {
  const LoosePanels cloth = loose_panels(garment, placed);
  Eigen::Matrix3Xd at = Eigen::Matrix3Xd::Zero(3, garment.vertex_count);
  for (std::size_t v = 0; v < cloth.garment_vertex.size(); ++v)
    at.col(cloth.garment_vertex[v]) = cloth.positions.col(static_cast<Eigen::Index>(v));
  const auto loops = boundary_loops(garment.triangles);
  return std::any_of(loops.begin(), loops.end(), [&](const std::vector<int>& loop) {
    const Eigen::Vector3d middle = at(Eigen::all, loop).rowwise().mean();
    return middle.y() < knee_height(form) && std::abs(middle.x()) > beside_middle * form.height;
  });
}

// What hangs below `ankles` is pushed together between there and `knee`: a hem that closes below the ankle closes beside the
// foot. It comes down when the cloth unfolds.
void gather_above(double ankles, double knee, Eigen::Matrix3Xd& x) {
  const double low = x.row(1).minCoeff();
  if (low >= ankles || knee <= ankles) return;
  const double share = (knee - ankles) / (knee - low);
  for (double& y : x.row(1))
    if (y < knee) y = knee - share * (knee - y);
}

}  // namespace

Start start_positions(const Pattern& pattern, const GarmentMesh& garment, const Body& body, double higher) {
  Start start;
  start.placed = place_panels(pattern, garment, body, higher);
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
  start.layer = panel_layers(pattern, garment);
  const std::vector<std::size_t> outwards = from_inside(start.layer);
  for (std::size_t arm = 0; arm < arms.size(); ++arm) {
    double least = 0;
    for (int layer = 0; layer <= outermost(start.layer); ++layer) {
      std::vector<FlatPanel> panels;
      std::vector<std::size_t> of_layer;
      for (const std::size_t p : on_arm[arm])
        if (start.layer[p] == layer) {
          of_layer.push_back(p);
          panels.push_back(flat[p]);
        }
      const auto rolled = rolled_round(arms[arm], panels, body, least);
      for (std::size_t i = 0; i < panels.size(); ++i) {
        start.placed[of_layer[i]] = rolled[i];
        least = std::max(least, radius_round(arms[arm], rolled[i]) + sleeve_gap);
      }
    }
    for (const std::size_t p : on_arm[arm]) outside[p] = (arms[arm].wrist - arms[arm].shoulder).normalized();
  }

  start.lift.assign(count, 0.0);
  const double kept = half_trunk * body.form.height;
  const double knee = knee_height(body.form);
  const double ankles = has_legs(garment, start.placed, body.form) ? ankle_height(body.form) : -1e9;
  const auto raised = [&](const std::vector<double>& lift, double narrowed) {
    auto placed = start.placed;
    for (std::size_t p = 0; p < count; ++p)
      if (lifted[p]) {
        placed[p].row(1).array() += lift[p];
        for (double& x : placed[p].row(0))
          if (std::abs(x) > kept) x = std::copysign(kept + narrowed * (std::abs(x) - kept), x);
        gather_above(ankles, knee, placed[p]);
      }
    for (int layer = 1; layer <= outermost(start.layer); ++layer) {
      std::vector<const Eigen::Matrix3Xd*> inner, outer;
      for (std::size_t p = 0; p < count; ++p)
        if (lifted[p] && start.layer[p] <= layer) (start.layer[p] < layer ? inner : outer).push_back(&placed[p]);
      const double wider = widening(inner, outer);
      start.widened = start.widened || wider > 1;
      for (std::size_t p = 0; p < count; ++p)
        if (lifted[p] && start.layer[p] == layer) widen(wider, placed[p]);
    }
    for (const std::size_t p : outwards)
      if (lifted[p]) {
        move_clear(body, outside[p], placed[p]);
        for (std::size_t inner = 0; inner < count; ++inner)
          if (lifted[inner] && start.layer[inner] < start.layer[p] && outside[inner].dot(outside[p]) > facing_alike)
            move_outside(placed[inner], outside[p], placed[p]);
      }
    return placed;
  };
  int fewest = blocked_stitches(loose_panels(garment, raised(start.lift, 1)), body);
  const auto keep_if_fewer = [&](const std::vector<double>& lift, double narrowed) {
    const int blocked = blocked_stitches(loose_panels(garment, raised(lift, narrowed)), body);
    if (blocked >= fewest) return;
    fewest = blocked;
    start.lift = lift;
    start.narrowed = narrowed;
  };
  // All panels together, then row by row: a bodice may have to go up to the arms and the trousers sewn to it not.
  const auto rows = rows_of(start.placed, lifted);
  const auto levels = static_cast<int>(std::lround(most_lift / step));
  const auto lift_row = [&](const std::vector<std::size_t>& row) {
    const std::vector<double> from = start.lift;
    for (int level = 1; level <= 2 * levels && fewest > 0; ++level) {
      auto lift = from;
      for (const std::size_t p : row) lift[p] += step * (level % 2 ? (level + 1) / 2 : -level / 2);  // 1, -1, 2, -2, ... cm
      keep_if_fewer(lift, start.narrowed);
    }
  };
  std::vector<std::size_t> all;
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
  if (!all.empty()) lift_row(all);
  if (rows.size() > 1)
    for (const auto& row : rows) lift_row(row);
  for (const double narrowed : narrower)
    if (fewest > 0) keep_if_fewer(start.lift, narrowed);
  for (double& lift : start.lift) lift += higher;
  for (std::size_t p = 0; p < count; ++p)
    start.gathered = start.gathered || (lifted[p] && start.placed[p].row(1).minCoeff() + start.lift[p] < ankles);
  start.placed = raised(start.lift, start.narrowed);
  part_touching(garment, outside, start.placed);
  const LoosePanels cloth = loose_panels(garment, start.placed);
  start.blocked_stitches = blocked_stitches(cloth, body);
  start.intersections = static_cast<int>(intersecting_triangles(cloth.positions, cloth.triangles).size());
  return start;
}

}  // namespace toile
