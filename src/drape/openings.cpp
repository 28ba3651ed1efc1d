#include "drape/openings.h"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <set>
#include <utility>

#include "body/relative.h"
#include "collide/links.h"
#include "garment/welds.h"
#include "geometry/topology.h"

namespace toile {
namespace {

constexpr double shortest_opening = 0.16;  // m round; a smaller one (a keyhole, a slit) lets no limb through
constexpr double beyond = 3.0;             // m, how far chains go on past the body

const LimbAxis* find_axis(const std::vector<LimbAxis>& axes, const std::string& name) {
  const auto found = std::find_if(axes.begin(), axes.end(), [&](const LimbAxis& axis) { return axis.name == name; });
  return found == axes.end() ? nullptr : &*found;
}

void go_on(std::vector<Eigen::Vector3d>& chain, const Eigen::Vector3d& way) { chain.push_back(chain.back() + beyond * way); }

int cloth_passed(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const std::vector<Eigen::Vector3d>& chain) {
  int passed = 0;
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    std::vector<Eigen::Vector3d> corners;
    for (int i = 0; i < 3; ++i) corners.push_back(positions.col(garment.triangles(i, t)));
    passed += std::abs(crossings(corners, chain));
  }
  return passed;
}

struct FreeWay {
  std::vector<Eigen::Vector3d> points;
  int passed = 0;  // triangles
};

// Of one limb, the way out that passes through the least cloth.
FreeWay free_way(const LimbChain& chain, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions) {
  FreeWay best{chain.points, cloth_passed(garment, positions, chain.points)};
  for (const auto& way : chain.other_ways) {
    if (best.passed == 0) break;
    const int passed = cloth_passed(garment, positions, way);
    if (passed < best.passed) best = {way, passed};
  }
  return best;
}

// The pelvis, where all chains begin, may lie on either side of a loop that does not go round the trunk: what head and feet
// have in common says nothing.
void count_from_trunk(const std::vector<LimbChain>& chains, std::vector<int>& through) {
  std::optional<int> common;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    if (chains[i].name.rfind("hand", 0) == 0) continue;
    if (common && *common != through[i]) return;
    common = through[i];
  }
  if (common)
    for (int& count : through) count -= *common;
}

std::string in_quotes(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "'" : ", '") + name + "'";
  return text;
}

bool holds(const Opening& opening, const std::string& limb) {
  return std::find(opening.limbs.begin(), opening.limbs.end(), limb) != opening.limbs.end();
}

}  // namespace

std::vector<LimbChain> limb_chains(const Mannequin& form) {
  std::vector<LimbChain> chains;
  const std::vector<LimbAxis> axes = limb_axes(form);
  const LimbAxis* trunk = find_axis(axes, "trunk");
  const LimbAxis* left = find_axis(axes, "leg.L");
  const LimbAxis* right = find_axis(axes, "leg.R");
  if (!trunk) return chains;
  if (!left || !right) {
    // A stand without limbs: what goes round it holds its upper and its lower end alike.
    LimbChain upper{"head", {(trunk->points.front() + trunk->points.back()) / 2, trunk->points.front()}, {}};
    LimbChain lower{"feet", {upper.points.front(), trunk->points.back()}, {}};
    go_on(upper.points, Eigen::Vector3d::UnitY());
    go_on(lower.points, -Eigen::Vector3d::UnitY());
    return {upper, lower};
  }
  // The spine from the pelvis up: the trunk's axis down to the hip joints, turned round.
  const Eigen::Vector3d pelvis = (left->points.front() + right->points.front()) / 2;
  std::vector<Eigen::Vector3d> spine{pelvis};
  for (auto point = trunk->points.rbegin(); point != trunk->points.rend(); ++point)
    if (point->y() > pelvis.y() + 1e-3) spine.push_back(*point);
  LimbChain head{"head", spine, {spine}};
  go_on(head.points, Eigen::Vector3d::UnitY());
  std::vector<Eigen::Vector3d>& out_of_face = head.other_ways.front();
  if (spine.size() > 1) out_of_face.back() = (spine[spine.size() - 2] + spine.back()) / 2;
  go_on(out_of_face, Eigen::Vector3d::UnitZ());
  chains.push_back(head);
  for (const char* side : {".L", ".R"}) {
    const LimbAxis* arm = find_axis(axes, std::string("arm") + side);
    if (!arm) continue;
    // Up the spine to the height of the shoulder, then out.
    LimbChain hand{std::string("hand") + side, {}, {}};
    for (const Eigen::Vector3d& point : spine)
      if (point.y() < arm->points.front().y() - 0.02 * form.height) hand.points.push_back(point);
    hand.points.insert(hand.points.end(), arm->points.begin(), arm->points.end());
    const double outwards = arm->points.back().x() < 0 ? -1 : 1;
    for (const Eigen::Vector3d& way : {Eigen::Vector3d(0, -1, 0), Eigen::Vector3d(outwards, 0, 0), Eigen::Vector3d(0, 1, 0)}) {
      hand.other_ways.push_back(hand.points);
      go_on(hand.other_ways.back(), way);
    }
    go_on(hand.points, (arm->points.back() - arm->points.front()).normalized());
    chains.push_back(hand);
  }
  for (const char* side : {".L", ".R"}) {
    const LimbAxis* leg = find_axis(axes, std::string("leg") + side);
    LimbChain foot{std::string("foot") + side, {pelvis}, {}};
    foot.points.insert(foot.points.end(), leg->points.begin(), leg->points.end());
    go_on(foot.points, -Eigen::Vector3d::UnitY());
    chains.push_back(foot);
  }
  return chains;
}

std::vector<Opening> openings(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Mannequin& form) {
  const std::vector<LimbChain> chains = limb_chains(form);
  std::vector<FreeWay> ways;
  for (const LimbChain& chain : chains) ways.push_back(free_way(chain, garment, positions));
  const auto segments = boundary_segments(garment);
  std::vector<Opening> all;
  std::set<std::pair<int, int>> free_edges;
  for (const BoundarySegment& segment : segments) {
    const Eigen::VectorXi& welded = garment.welded[static_cast<std::size_t>(segment.panel)];
    if (segment.mates.empty()) free_edges.insert(std::minmax(welded(segment.from), welded(segment.to)));
  }
  for (const auto& loop : boundary_loops(garment.triangles)) {
    // A layer that hangs open from a seam of others, such as an apron, has an edge all round and no opening.
    bool open = true;
    for (std::size_t i = 0; i < loop.size(); ++i)
      open = open && free_edges.count(std::minmax(loop[i], loop[(i + 1) % loop.size()])) > 0;
    if (!open) continue;
    Opening opening{.loop = loop};
    const std::set<int> on_loop(loop.begin(), loop.end());
    std::set<int> panels;
    for (const BoundarySegment& segment : segments) {
      if (!segment.mates.empty()) continue;
      const auto p = static_cast<std::size_t>(segment.panel);
      if (!on_loop.count(garment.welded[p](segment.from)) || !on_loop.count(garment.welded[p](segment.to))) continue;
      panels.insert(segment.panel);
      opening.length += (garment.panels[p].rest.col(segment.from) - garment.panels[p].rest.col(segment.to)).norm();
    }
    for (const int p : panels) opening.pieces.push_back(garment.panels[static_cast<std::size_t>(p)].name);
    opening.name = "opening along " + in_quotes(opening.pieces);
    std::vector<Eigen::Vector3d> points;
    for (const int v : loop) points.push_back(positions.col(v));
    std::vector<int> through;
    for (const FreeWay& way : ways) through.push_back(crossings(points, way.points));
    count_from_trunk(chains, through);
    for (std::size_t i = 0; i < chains.size(); ++i) {
      if (through[i] != 0) opening.limbs.push_back(chains[i].name);
      opening.wound = opening.wound || std::abs(through[i]) > 1;
    }
    all.push_back(std::move(opening));
  }
  return all;
}

Report check_openings(const std::vector<Opening>& openings, const GarmentMesh& garment,
                      const std::vector<std::string>& sleeve_of) {
  Report report;
  if (!openings.empty() &&
      std::all_of(openings.begin(), openings.end(), [](const Opening& opening) { return opening.limbs.empty(); })) {
    report.error("drape.not-around-body", "garment", "no opening of the sewn garment goes round the body",
                 "Check where the pieces are placed and which edges are left open", Fault::not_converged);
    return report;
  }
  const char* remedy = "Look at the picture; check where the pieces along it are placed and that the pattern is sewn as meant";
  for (const Opening& opening : openings) {
    const auto wrong = [&](const std::string& text) {
      report.error("drape.linked-wrong", opening.name, text, remedy, Fault::checks_failed);
    };
    if (opening.wound) wrong("a limb goes through it more than once");
    if (opening.limbs.empty()) {
      if (opening.length >= shortest_opening) wrong("nothing goes through it: the body is beside it");
      continue;
    }
    const bool foot = holds(opening, "foot.L") || holds(opening, "foot.R");
    const bool above = holds(opening, "head") || holds(opening, "hand.L") || holds(opening, "hand.R");
    if (foot && above) wrong(in_quotes(opening.limbs) + " go through it together");
    for (std::size_t p = 0; p < garment.panels.size(); ++p) {
      const std::string& limb = sleeve_of[p];
      const bool along =
          std::find(opening.pieces.begin(), opening.pieces.end(), garment.panels[p].name) != opening.pieces.end();
      if (!along || limb.empty()) continue;
      if (!holds(opening, limb)) wrong(in_quotes(opening.limbs) + " instead of '" + limb + "' goes through it");
      break;
    }
  }
  return report;
}

Report check_caught(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Mannequin& form) {
  Report report;
  for (const LimbChain& chain : limb_chains(form))
    if (free_way(chain, garment, positions).passed > 0)
      report.error("drape.linked-wrong", "'" + chain.name + "'", "is caught in the garment: it goes through the cloth",
                   "Look at the picture; place the pieces beside it farther away from it", Fault::not_converged);
  return report;
}

}  // namespace toile
