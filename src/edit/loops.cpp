#include "edit/loops.h"

#include <Eigen/Dense>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "edit/edge_chain.h"
#include "edit/level_loops.h"
#include "edit/worn_loops.h"
#include "garment/units.h"
#include "geometry/topology.h"

namespace toile {
namespace {

std::string list_of_names(const EditInput& input) {
  std::set<std::string> edges;
  for (const Piece& piece : input.pattern.pieces)
    for (const Edge& edge : piece.outline) edges.insert(piece.name + "." + edge.id);
  std::string list = "hem, waist, armhole (armhole.L, armhole.R), neckline; edges:";
  for (const std::string& edge : edges) list += " " + edge;
  list += "; heights:";
  for (const auto& [landmark, height] : input.body.form.landmarks) list += " " + landmark;
  list += "; bones (as NAME:0.5):";
  for (const Bone& bone : input.body.form.bones) list += " " + bone.name;
  return list;
}

std::vector<VertexLoop> round_trunk_or_legs(const EditInput& input, const std::vector<VertexLoop>& loops) {
  const auto chains = skeleton_chains(input.body.form);
  std::vector<VertexLoop> found;
  for (const VertexLoop& loop : loops)
    if (threading(chains, input.drape, loop).round_trunk_or_leg()) found.push_back(loop);
  return found;
}

std::vector<VertexLoop> lowest_free_boundary(const EditInput& input) {
  const auto chains = skeleton_chains(input.body.form);
  std::vector<VertexLoop> round = round_trunk_or_legs(input, boundary_loops(input.garment.triangles));
  const auto lowest = std::min_element(round.begin(), round.end(), [&](const VertexLoop& a, const VertexLoop& b) {
    return loop_centre(input.drape, a).y() < loop_centre(input.drape, b).y();
  });
  if (lowest == round.end()) return {};
  std::vector<VertexLoop> found;
  const auto of_lowest = threading(chains, input.drape, *lowest);
  const double height = loop_centre(input.drape, *lowest).y();
  for (const VertexLoop& loop : round) {
    const auto here = threading(chains, input.drape, loop);
    const bool other_leg = of_lowest.heads == 0 && of_lowest.feet == 1 && here.heads == 0 && here.feet == 1 &&
                           std::abs(loop_centre(input.drape, loop).y() - height) < 0.05;
    if (&loop == &*lowest || other_leg) found.push_back(loop);
  }
  return found;
}

// The top of a skirt or of trousers: a boundary that everything above, or both legs below, pass through.
std::vector<VertexLoop> highest_free_boundary(const EditInput& input) {
  const auto chains = skeleton_chains(input.body.form);
  int hands = 0, feet = 0;
  for (const SkeletonChain& chain : chains) {
    hands += chain.end == ChainEnd::hand;
    feet += chain.end == ChainEnd::foot;
  }
  const VertexLoop* highest = nullptr;
  const auto loops = boundary_loops(input.garment.triangles);
  const auto hem = lowest_free_boundary(input);
  for (const VertexLoop& loop : loops) {
    const auto here = threading(chains, input.drape, loop);
    if (!((here.heads > 0 && here.hands == hands) || (feet > 0 && here.feet == feet))) continue;
    if (std::find(hem.begin(), hem.end(), loop) != hem.end()) continue;
    if (!highest || loop_centre(input.drape, loop).y() > loop_centre(input.drape, *highest).y()) highest = &loop;
  }
  if (!highest) return {};
  const auto waist = input.body.form.landmarks.find("waist");
  constexpr double near = 0.12;  // m: the top of a strapless dress is no waist
  if (waist != input.body.form.landmarks.end() && std::abs(loop_centre(input.drape, *highest).y() - waist->second) > near)
    return {};
  return {*highest};
}

// Named by how the garment is worn; absent for other names.
std::optional<std::vector<VertexLoop>> worn_loops(const EditInput& input, const std::string& name, const std::string& place) {
  std::vector<VertexLoop> found;
  if (name == "neckline") {
    found = necklines(input);
  } else if (name == "armhole" || name == "armhole.L" || name == "armhole.R") {
    for (Armhole& armhole : armholes(input))
      if (name == "armhole" || (name.back() == 'L') == armhole.left) found.push_back(std::move(armhole.loop));
  } else {
    return std::nullopt;
  }
  if (found.empty())
    throw BadInput({"edit.no-loop-there", Severity::error, place, "the garment has no closed " + name,
                    name == "neckline" ? "sew its opening in the pattern, or name the edges round the neck"
                                       : "where sleeves and bodice are one piece or the seam ends at the neck, choose a level "
                                         "of the arm such as \"upperarm.L:0.3\""});
  return found;
}

struct Level {
  Eigen::Vector3d at, normal;
  bool of_bone = false;
};

std::optional<Level> level_named(const EditInput& input, const std::string& name, const std::string& place) {
  const Mannequin& form = input.body.form;
  const auto landmark = form.landmarks.find(name);
  if (landmark != form.landmarks.end()) return Level{{0, landmark->second, 0}, Eigen::Vector3d::UnitY(), false};
  const std::size_t colon = name.rfind(':');
  if (colon == std::string::npos) return std::nullopt;
  const Bone* bone = find_bone(form, name.substr(0, colon));
  if (!bone) return std::nullopt;
  double share = 0;
  const auto [end, error] = std::from_chars(name.data() + colon + 1, name.data() + name.size(), share);
  if (error != std::errc{} || end != name.data() + name.size() || !(share >= 0 && share <= 1))
    throw BadInput({"edit.unknown-loop", Severity::error, place, "'" + name + "' does not say where on the bone",
                    "write a share of the bone between 0 and 1, such as \"" + bone->name + ":0.5\""});
  const Eigen::Vector3d along = (bone->to - bone->from).normalized();
  const bool upright = std::abs(along.y()) > 0.8;
  return Level{bone->from + share * (bone->to - bone->from), upright ? Eigen::Vector3d::UnitY() : along, true};
}

NamedLoops loops_at(const EditInput& input, const Level& level, const std::string& name, const std::string& place,
                    LevelSide side) {
  const Eigen::VectorXd field = (level.normal.transpose() * (input.drape.colwise() - level.at)).transpose();
  const LevelLoops all = level_loops(level_mesh(input.garment.triangles), field, 0, side);
  std::vector<VertexLoop> found;
  if (level.of_bone) {
    for (const VertexLoop& loop : all.closed)
      if (crossings(input.drape, loop, level.at - 0.05 * level.normal, level.at + 0.05 * level.normal) != 0)
        found.push_back(loop);
  } else {
    found = round_trunk_or_legs(input, all.closed);
  }
  if (!found.empty()) return {found, Eigen::Hyperplane<double, 3>(level.normal, level.at)};
  if (!level.of_bone) {            // a bodice that ends at the waist ends a little above or below it
    constexpr double near = 0.05;  // m
    for (VertexLoop& edge : round_trunk_or_legs(input, boundary_loops(input.garment.triangles)))
      if (std::abs(loop_centre(input.drape, edge).y() - level.at.y()) < near) found.push_back(std::move(edge));
    if (!found.empty()) return {found, {}};
  }
  if (all.open > 0)
    throw BadInput({"edit.open-chain", Severity::error, place, "the garment is open at '" + name + "'",
                    "sew the opening in the pattern, or choose a loop where the garment closes round the body"});
  throw BadInput({"edit.no-loop-there", Severity::error, place,
                  "the garment has no closed loop round the body at '" + name + "'; it reaches from " +
                      in_mm(input.drape.row(1).minCoeff(), 0) + " to " + in_mm(input.drape.row(1).maxCoeff(), 0) +
                      " above the floor",
                  "choose a level within the garment"});
}

}  // namespace

std::vector<std::string> split_names(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ',')
      parts.emplace_back();
    else if (c != ' ' || !parts.back().empty())
      parts.back() += c;
  }
  for (std::string& part : parts)
    while (!part.empty() && part.back() == ' ') part.pop_back();
  return parts;
}

double loop_length(const Eigen::Matrix3Xd& positions, const VertexLoop& loop) {
  double length = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += (positions.col(loop[i]) - positions.col(loop[(i + 1) % loop.size()])).norm();
  return length;
}

Eigen::Vector3d loop_centre(const Eigen::Matrix3Xd& positions, const VertexLoop& loop) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Eigen::Vector3d a = positions.col(loop[i]), b = positions.col(loop[(i + 1) % loop.size()]);
    sum += (a - b).norm() * (a + b) / 2;
  }
  return sum / std::max(1e-12, loop_length(positions, loop));
}

NamedLoops resolve_loops(const EditInput& input, const std::string& name, const std::string& place, LevelSide side) {
  std::vector<PanelEdge> edges;
  std::optional<std::string> unknown;
  for (const std::string& part : split_names(name)) {
    const auto more = edges_named(input.pattern, input.garment, part);
    edges.insert(edges.end(), more.begin(), more.end());
    if (more.empty() && !unknown) unknown = part;
  }
  // Edges called "waist" of a pattern with darts there do not close; its height is what is meant then.
  if (!unknown && input.body.form.landmarks.count(name)) try {
      closed_chains(input.pattern, input.garment, input.drape, edges, place, name);
    } catch (const BadInput&) {
      return loops_at(input, *level_named(input, name, place), name, place, side);
    }
  // Likewise edges called "armhole" of a garment whose sleeves are in more pieces.
  if (const auto worn = unknown ? worn_loops(input, name, place) : std::nullopt) return {*worn, {}};
  if (!unknown && (name.rfind("armhole", 0) == 0 || name == "neckline")) try {
      return {closed_chains(input.pattern, input.garment, input.drape, edges, place, name), {}};
    } catch (const BadInput&) {
      return {*worn_loops(input, name, place), {}};
    }
  if (!unknown) {
    const auto loops = closed_chains(input.pattern, input.garment, input.drape, edges, place, name);
    const auto round = name == "hem" ? round_trunk_or_legs(input, loops) : loops;
    return {round.empty() ? loops : round, {}};
  }
  std::vector<VertexLoop> loops;
  if (name == "hem") loops = lowest_free_boundary(input);
  if (name == "waist") loops = highest_free_boundary(input);
  if (!loops.empty()) return {loops, {}};
  if (const auto level = level_named(input, name, place)) return loops_at(input, *level, name, place, side);
  throw BadInput({"edit.unknown-loop", Severity::error, place, "the garment has no loop '" + *unknown + "'",
                  "there are: " + list_of_names(input)});
}

}  // namespace toile
