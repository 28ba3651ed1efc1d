#include "drape/placement.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "drape/layers.h"
#include "drape/side_by_side.h"

namespace toile {
namespace {

constexpr double clearance = 0.01;  // m, between the body and a rolled panel
constexpr double side_gap = 0.01;   // m, between panels side by side
constexpr double layer_gap = 0.02;  // m, between panels of two layers

// Axes of a body part at the height where panels begin: `up` along the part towards its root, `front` and `left` across it.
struct PartFrame {
  Eigen::Vector3d origin, up, front, left;
};

double height_of(const BodyPart& part, const Body& body) { return level_height(body.form, part.level) - part.drop; }

// Part of the body near the trunk: arms stand away from it.
bool near_trunk(const Mannequin& form, const Eigen::Vector3d& at) { return std::abs(at.x()) < 0.155 * form.height; }

PartFrame trunk_frame(const Mannequin& form, double top) {
  double low = 1e9;
  double high = -1e9;
  for (Eigen::Index v = 0; v < form.positions.cols(); ++v) {
    const Eigen::Vector3d at = form.positions.col(v);
    if (std::abs(at.y() - top) > 0.03 || !near_trunk(form, at)) continue;
    low = std::min(low, at.z());
    high = std::max(high, at.z());
  }
  const double z = low < high ? (low + high) / 2 : 0;
  return {{0, top, z}, Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()};
}

// Where on a limb's axis, which begins at `root` and points away along -up, a level lies: m, towards the root.
double along_limb(const Mannequin& form, const BodyPart& part, const Eigen::Vector3d& root, const Eigen::Vector3d& up,
                  const std::string& place) {
  if (part.level == "shoulder") return 0;
  const double rise = level_height(form, part.level) - root.y();
  if (std::abs(up.y()) < 0.3)  // held out: all of it is at about one height
    throw BadInput({"drape.level-beside-limb", Severity::error, place,
                    "'" + part.part + "' is held out level, so '" + part.level + "' is no place on it",
                    "Give level = \"shoulder\" and how far along the arm as drop"});
  return rise / up.y();
}

// From the first bone's start to the last one's end ("upperarm.L" .. "lowerarm.L").
PartFrame limb_frame(const Mannequin& form, const BodyPart& part, const std::string& place) {
  const bool arm = part.part.rfind("arm", 0) == 0;
  const std::string side = part.part.size() >= 2 ? part.part.substr(part.part.size() - 2) : std::string{};
  const Bone* upper = nullptr;
  const Bone* lower = nullptr;
  for (const char* name : {"upperarm", "upper_arm", "thigh", "upperleg", "upleg"}) {
    const bool is_arm = std::string(name).find("arm") != std::string::npos;
    if (is_arm == arm && !upper) upper = find_bone(form, name + side);
  }
  for (const char* name : {"forearm", "lowerarm", "lower_arm", "shin", "lowerleg", "calf", "leg"}) {
    const bool is_arm = std::string(name).find("arm") != std::string::npos;
    if (is_arm == arm && !lower) lower = find_bone(form, name + side);
  }
  if (!upper || !lower)
    throw BadInput({"drape.no-such-part", Severity::error, place, "the body has no bones for part '" + part.part + "'",
                    "Use trunk, arm.L, arm.R, leg.L or leg.R, and a body whose skeleton has those bones"});
  const Eigen::Vector3d up = (upper->from - lower->to).normalized();
  const Eigen::Vector3d front = (Eigen::Vector3d::UnitZ() - up.z() * up).normalized();
  return {upper->from + (along_limb(form, part, upper->from, up, place) - part.drop) * up, up, front, up.cross(front)};
}

// Radius round the frame's axis by depth below its origin, in rows of `row_height`.
using Radii = std::vector<double>;
constexpr double row_height = 0.02;  // m

std::size_t row_of(double below) { return static_cast<std::size_t>(std::max(0.0, below) / row_height); }

// Largest distance of the body from the frame's axis, by row.
Radii body_radii(const Mannequin& form, const PartFrame& frame, std::size_t rows, bool trunk) {
  Radii radii(rows, 0.0);
  for (Eigen::Index v = 0; v < form.positions.cols(); ++v) {
    const Eigen::Vector3d from = form.positions.col(v) - frame.origin;
    const double along = from.dot(frame.up);
    if (trunk && !near_trunk(form, form.positions.col(v))) continue;
    const double across = (from - along * frame.up).norm();
    if (!trunk && across > 0.12) continue;
    for (const double reach : {-row_height, 0.0, row_height}) {
      const double below = reach - along;
      if (below >= 0 && row_of(below) < rows) radii[row_of(below)] = std::max(radii[row_of(below)], across);
    }
  }
  return radii;
}

// Widens the circles where a panel of a layer under them goes round.
void clear_of_layer(const Eigen::Matrix3Xd& inner, const PartFrame& frame, Radii& radii) {
  for (Eigen::Index v = 0; v < inner.cols(); ++v) {
    const Eigen::Vector3d from = inner.col(v) - frame.origin;
    const double along = from.dot(frame.up);
    const double needed = (from - along * frame.up).norm() + layer_gap;
    for (const double reach : {-row_height, 0.0, row_height}) {
      const double below = reach - along;
      if (below >= 0 && row_of(below) < radii.size()) radii[row_of(below)] = std::max(radii[row_of(below)], needed);
    }
  }
}

// How far a panel (grain upright) reaches from its middle, by row below its top, and in the rows above and below that.
RolledPanel reach_of(const PanelMesh& panel, const Eigen::Matrix2Xd& flat, double angle) {
  const double top = flat.row(1).maxCoeff();
  const double middle = (flat.row(0).minCoeff() + flat.row(0).maxCoeff()) / 2;
  const std::size_t rows = row_of(top - flat.row(1).minCoeff()) + 1;
  RolledPanel reach{angle, Radii(rows, 0.0), Radii(rows, 0.0)};
  for (Eigen::Index t = 0; t < panel.triangles.cols(); ++t) {
    const Eigen::Matrix<double, 2, 3> corners = flat(Eigen::all, panel.triangles.col(t));
    const std::size_t from = row_of(top - corners.row(1).maxCoeff() - row_height);
    const std::size_t to = row_of(top - corners.row(1).minCoeff() + row_height);
    for (std::size_t row = from; row <= std::min(to, rows - 1); ++row) {
      reach.left[row] = std::max(reach.left[row], middle - corners.row(0).minCoeff());
      reach.right[row] = std::max(reach.right[row], corners.row(0).maxCoeff() - middle);
    }
  }
  return reach;
}

double radius_at(const Radii& radii, double below) {
  const double place = std::clamp(below / row_height - 0.5, 0.0, static_cast<double>(radii.size() - 1));
  const auto row = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(row);
  return row + 1 < radii.size() ? (1 - share) * radii[row] + share * radii[row + 1] : radii[row];
}

constexpr double lying = 1e-6;

// Rest positions turned so that the grain stands upright, or runs round; a grain line has no head, so by less than a half turn,
// and by a quarter turn always with the clock.
Eigen::Matrix2Xd as_worn(const PanelMesh& panel, bool grain_round) {
  Eigen::Vector2d up = grain_round ? Eigen::Vector2d(-panel.warp.y(), panel.warp.x()) : panel.warp;
  if (up.y() < -lying || (up.y() < lying && up.x() > 0)) up = -up;
  Eigen::Matrix2d turn;
  turn << up.y(), -up.x(), up.x(), up.y();
  return turn * panel.rest;
}

Eigen::Matrix3Xd rolled(const Eigen::Matrix2Xd& flat, const PartFrame& frame, const Radii& radii, double angle) {
  const double middle = (flat.row(0).minCoeff() + flat.row(0).maxCoeff()) / 2;
  const double top = flat.row(1).maxCoeff();
  Eigen::Matrix3Xd placed(3, flat.cols());
  for (Eigen::Index v = 0; v < flat.cols(); ++v) {
    const double radius = radius_at(radii, top - flat(1, v));
    const double theta = angle + (flat(0, v) - middle) / radius;
    placed.col(v) =
        frame.origin + (flat(1, v) - top) * frame.up + radius * (std::sin(theta) * frame.left + std::cos(theta) * frame.front);
  }
  return placed;
}

}  // namespace

std::vector<Eigen::Matrix3Xd> place_panels(const Pattern& pattern, const GarmentMesh& garment, const Body& body,
                                           double higher) {
  std::vector<Eigen::Matrix3Xd> placed(garment.panels.size());
  // Panels of one part and level go round it side by side: at every height on a circle that has room for them and clears the
  // body.
  std::map<std::tuple<int, std::string, std::string, double>, std::vector<std::size_t>> levels;
  const std::vector<int> layers = panel_layers(pattern, garment);
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    const auto copy = static_cast<std::size_t>(panel.copy - 1);
    if (copy < piece.placement.size() && piece.placement[copy]) {
      Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, panel.rest.cols());
      flat.topRows<2>() = panel.rest;
      placed[p] = (piece.placement[copy]->rotation * flat).colwise() + piece.placement[copy]->translation;
    } else if (copy < piece.body_part.size() && piece.body_part[copy]) {
      const BodyPart& part = *piece.body_part[copy];
      levels[{layers[p], part.part, part.level, part.drop}].push_back(p);
    } else {
      throw BadInput({"drape.no-placement", Severity::error, "piece '" + panel.name + "'",
                      "nothing says where on the body this piece sits",
                      "Give it a place in the seams file: on = { part = \"trunk\", level = \"waist\", angle = 0 }"});
    }
  }
  for (const auto& [level, panels] : levels) {
    std::vector<RolledPanel> sides;
    std::vector<Eigen::Matrix2Xd> flats;
    std::size_t rows = 0;
    BodyPart part;
    for (const std::size_t p : panels) {
      const PanelMesh& panel = garment.panels[p];
      part = *pattern.pieces[static_cast<std::size_t>(panel.piece)].body_part[static_cast<std::size_t>(panel.copy - 1)];
      flats.push_back(as_worn(panel, part.grain_round));
      sides.push_back(reach_of(panel, flats.back(), part.angle));
      rows = std::max(rows, sides.back().left.size());
    }
    const bool trunk = part.part == "trunk";
    PartFrame frame = trunk ? trunk_frame(body.form, height_of(part, body) + higher)
                            : limb_frame(body.form, part, "piece '" + garment.panels[panels.front()].name + "'");
    if (part.part.rfind("leg", 0) == 0) frame.origin += higher * frame.up;
    Radii radii = body_radii(body.form, frame, rows, trunk);
    for (double& radius : radii) radius += clearance;
    for (const auto& [under, inner] : levels)
      for (const std::size_t p : inner)
        if (std::get<0>(under) < std::get<0>(level) && std::get<1>(under) == part.part) clear_of_layer(placed[p], frame, radii);
    give_room(sides, side_gap, radii);
    for (std::size_t i = 0; i < panels.size(); ++i) placed[panels[i]] = rolled(flats[i], frame, radii, sides[i].angle);
  }
  return placed;
}

}  // namespace toile
