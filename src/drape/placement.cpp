#include "drape/placement.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace toile {
namespace {

constexpr double clearance = 0.01;  // m, between the body and a rolled panel

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
  return {upper->from - part.drop * up, up, front, up.cross(front)};
}

// Largest distance of the body from the frame's axis between `below` and the frame's origin.
double body_radius(const Mannequin& form, const PartFrame& frame, double below, bool trunk) {
  double radius = 0;
  for (Eigen::Index v = 0; v < form.positions.cols(); ++v) {
    const Eigen::Vector3d from = form.positions.col(v) - frame.origin;
    const double along = from.dot(frame.up);
    if (along > 0.02 || along < -below - 0.02) continue;
    if (trunk && !near_trunk(form, form.positions.col(v))) continue;
    const double across = (from - along * frame.up).norm();
    if (trunk || across < 0.12) radius = std::max(radius, across);
  }
  return radius;
}

// Rest positions with the grain turned upright.
Eigen::Matrix2Xd upright(const PanelMesh& panel) {
  Eigen::Matrix2d turn;
  turn << panel.warp.y(), -panel.warp.x(), panel.warp.x(), panel.warp.y();
  return turn * panel.rest;
}

Eigen::Matrix3Xd rolled(const Eigen::Matrix2Xd& flat, const PartFrame& frame, double radius, double angle) {
  const double middle = (flat.row(0).minCoeff() + flat.row(0).maxCoeff()) / 2;
  const double top = flat.row(1).maxCoeff();
  Eigen::Matrix3Xd placed(3, flat.cols());
  for (Eigen::Index v = 0; v < flat.cols(); ++v) {
    const double theta = angle + (flat(0, v) - middle) / radius;
    placed.col(v) =
        frame.origin + (flat(1, v) - top) * frame.up + radius * (std::sin(theta) * frame.left + std::cos(theta) * frame.front);
  }
  return placed;
}

}  // namespace

std::vector<Eigen::Matrix3Xd> place_panels(const Pattern& pattern, const GarmentMesh& garment, const Body& body) {
  std::vector<Eigen::Matrix3Xd> placed(garment.panels.size());
  // Panels of one part and level share a radius on which their widths fit side by side.
  using Level = std::tuple<std::string, std::string, double>;
  std::map<Level, std::pair<double, double>> extent;  // sum of widths, greatest length
  const auto part_of = [&](const PanelMesh& panel) -> const BodyPart* {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    const auto copy = static_cast<std::size_t>(panel.copy - 1);
    return copy < piece.body_part.size() && piece.body_part[copy] ? &*piece.body_part[copy] : nullptr;
  };
  const auto placement_of = [&](const PanelMesh& panel) -> const Placement* {
    const Piece& piece = pattern.pieces[static_cast<std::size_t>(panel.piece)];
    const auto copy = static_cast<std::size_t>(panel.copy - 1);
    return copy < piece.placement.size() && piece.placement[copy] ? &*piece.placement[copy] : nullptr;
  };
  for (const PanelMesh& panel : garment.panels) {
    const BodyPart* part = part_of(panel);
    if (placement_of(panel) || !part) continue;
    const Eigen::Matrix2Xd flat = upright(panel);
    auto& [width, tall] = extent[{part->part, part->level, part->drop}];
    width += flat.row(0).maxCoeff() - flat.row(0).minCoeff();
    tall = std::max(tall, flat.row(1).maxCoeff() - flat.row(1).minCoeff());
  }
  for (std::size_t p = 0; p < garment.panels.size(); ++p) {
    const PanelMesh& panel = garment.panels[p];
    if (const Placement* placement = placement_of(panel)) {
      Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, panel.rest.cols());
      flat.topRows<2>() = panel.rest;
      placed[p] = (placement->rotation * flat).colwise() + placement->translation;
      continue;
    }
    const std::string place = "piece '" + panel.name + "'";
    const BodyPart* part = part_of(panel);
    if (!part)
      throw BadInput({"drape.no-placement", Severity::error, place, "nothing says where on the body this piece sits",
                      "Give it a place in the seams file: on = { part = \"trunk\", level = \"waist\", angle = 0 }"});
    const bool trunk = part->part == "trunk";
    const PartFrame frame = trunk ? trunk_frame(body.form, height_of(*part, body)) : limb_frame(body.form, *part, place);
    const auto& [width, tall] = extent.at({part->part, part->level, part->drop});
    const double radius = std::max(width / (2 * std::numbers::pi), body_radius(body.form, frame, tall, trunk) + clearance);
    placed[p] = rolled(upright(panel), frame, radius, part->angle);
  }
  return placed;
}

}  // namespace toile
