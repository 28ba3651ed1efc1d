#include "drape/limb_panels.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace toile {
namespace {

constexpr double least_radius = 0.052;  // m, of the height 1.68 m figure's arm with room
constexpr double clearance = 5e-3;      // m, between the body and a rolled panel

Eigen::Vector3d middle_of(const Eigen::Matrix3Xd& x) { return (x.rowwise().minCoeff() + x.rowwise().maxCoeff()) / 2; }

double distance_to_segment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

// The panel laid out along the arm: `along` from the shoulder, `across` from the middle of the panel; `towards` is the
// direction round the arm that its outside faces.
struct LaidOut {
  Eigen::VectorXd along, across;
  double towards = 0;  // radians from the front
};

struct ArmFrame {
  Eigen::Vector3d origin, along, front, side;  // side: front turned by 90 degrees
};

ArmFrame frame_of(const ArmLine& arm) {
  const Eigen::Vector3d along = (arm.wrist - arm.shoulder).normalized();
  const Eigen::Vector3d front = (Eigen::Vector3d::UnitZ() - along.z() * along).normalized();
  return {arm.shoulder, along, front, along.cross(front)};
}

LaidOut lay_out(const FlatPanel& panel, const ArmFrame& frame) {
  // The pattern's own axis nearest to the arm.
  Eigen::Vector3d along = panel.axes.col(0);
  for (const Eigen::Vector3d& axis :
       {Eigen::Vector3d(-panel.axes.col(0)), Eigen::Vector3d(panel.axes.col(1)), Eigen::Vector3d(-panel.axes.col(1))})
    if (axis.dot(frame.along) > along.dot(frame.along)) along = axis;
  const Eigen::Vector3d outside = panel.axes.col(2);
  const Eigen::Vector3d across = along.cross(outside);  // of a front panel: the side of the frame
  LaidOut laid;
  laid.along = (panel.positions.colwise() - frame.origin).transpose() * along;
  laid.across = panel.positions.transpose() * across;
  laid.across.array() -= (laid.across.minCoeff() + laid.across.maxCoeff()) / 2;
  laid.towards = std::atan2(outside.dot(frame.side), outside.dot(frame.front));
  return laid;
}

Eigen::Matrix3Xd bent(const LaidOut& laid, const ArmFrame& frame, double radius) {
  Eigen::Matrix3Xd x(3, laid.along.size());
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const double angle = laid.towards + laid.across(v) / radius;
    x.col(v) =
        frame.origin + laid.along(v) * frame.along + radius * (std::cos(angle) * frame.front + std::sin(angle) * frame.side);
  }
  return x;
}

bool clear_of(const Body& body, const Eigen::Matrix3Xd& x) {
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    if (body.distance.distance(x.col(v)) < clearance) return false;
  return true;
}

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

// Panels face one of two opposite ways, however crookedly they were placed: two halves of a sleeve that do not would overlap.
void face_to_face(std::vector<LaidOut>& laid) {
  double x = 0;
  double y = 0;
  for (const LaidOut& panel : laid) {
    x += std::cos(2 * panel.towards);
    y += std::sin(2 * panel.towards);
  }
  const double way = std::atan2(y, x) / 2;
  for (LaidOut& panel : laid)
    panel.towards = angle_between(panel.towards, way) < std::numbers::pi / 2 ? way : way + std::numbers::pi;
}

// Panels that face the same way stand one after the other along the arm.
void spread_along(std::vector<LaidOut>& laid) {
  std::vector<std::size_t> order(laid.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto middle = [&](std::size_t i) { return laid[i].along.minCoeff() + laid[i].along.maxCoeff(); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return middle(a) < middle(b); });
  double shift = 0;
  for (std::size_t i = 1; i < order.size(); ++i) {
    double needed = shift;
    for (std::size_t k = 0; k < i; ++k)
      if (angle_between(laid[order[k]].towards, laid[order[i]].towards) < std::numbers::pi / 2)
        needed = std::max(needed, laid[order[k]].along.maxCoeff() + clearance - laid[order[i]].along.minCoeff());
    if (needed > 0) laid[order[i]].along.array() += needed;
  }
}

}  // namespace

std::vector<ArmLine> arm_lines(const Mannequin& form) {
  std::vector<ArmLine> arms;
  for (const LimbAxis& axis : limb_axes(form)) {
    if (axis.name != "arm.L" && axis.name != "arm.R") continue;
    ArmLine arm{.name = axis.name, .shoulder = axis.points.front(), .wrist = axis.points.back()};
    if (axis.points.size() > 2) arm.wrist = axis.points[axis.points.size() - 2];
    arm.to_finger_tips = (axis.points.back() - arm.shoulder).dot((arm.wrist - arm.shoulder).normalized());
    arms.push_back(arm);
  }
  return arms;
}

std::optional<std::size_t> arm_of(const FlatPanel& panel, const std::vector<ArmLine>& arms, const Mannequin& form) {
  const Eigen::Vector2d middle = middle_of(panel.positions).head<2>();
  for (std::size_t i = 0; i < arms.size(); ++i) {
    const Eigen::Vector3d along = (arms[i].wrist - arms[i].shoulder).normalized();
    if (std::abs(along.dot(panel.axes.col(2))) > 0.5) continue;  // stands across the arm
    const Eigen::Vector3d tips = arms[i].shoulder + arms[i].to_finger_tips * along;
    const double to_arm = distance_to_segment(middle, arms[i].shoulder.head<2>(), tips.head<2>());
    if (to_arm > 0.4 * std::abs(middle.x())) continue;  // nearer to the trunk
    const Eigen::VectorXd place = (panel.positions.colwise() - arms[i].shoulder).transpose() * along;
    const double outside = 0.06 * form.height;
    const auto on_arm = (place.array() > -outside && place.array() < arms[i].to_finger_tips + outside).count();
    if (static_cast<double>(on_arm) > 0.8 * static_cast<double>(place.size())) return i;
  }
  return std::nullopt;
}

std::vector<Eigen::Matrix3Xd> rolled_round(const ArmLine& arm, const std::vector<FlatPanel>& panels, const Body& body,
                                           double least) {
  const ArmFrame frame = frame_of(arm);
  std::vector<LaidOut> laid;
  for (const FlatPanel& panel : panels) laid.push_back(lay_out(panel, frame));
  face_to_face(laid);
  spread_along(laid);
  // A panel with another across the arm from it has half of the circle, one that is alone all of it.
  double radius = std::max(least, least_radius * body.form.height / 1.68);
  for (const LaidOut& panel : laid) {
    const bool shared = std::any_of(laid.begin(), laid.end(), [&](const LaidOut& other) {
      return angle_between(panel.towards, other.towards) > std::numbers::pi / 2;
    });
    const double width = panel.across.maxCoeff() - panel.across.minCoeff();
    radius = std::max(radius, (width + clearance) / (shared ? std::numbers::pi : 2 * std::numbers::pi));
  }
  std::vector<Eigen::Matrix3Xd> rolled(laid.size());
  for (double shift = 0; shift < 0.25; shift += 0.02)
    for (double grown = 1; grown < 1.5; grown *= 1.05) {
      bool clear = true;
      for (std::size_t i = 0; i < laid.size(); ++i) {
        LaidOut moved = laid[i];
        moved.along.array() += shift;
        rolled[i] = bent(moved, frame, grown * radius);
        clear = clear && clear_of(body, rolled[i]);
      }
      if (clear) return rolled;
    }
  return rolled;
}

double radius_round(const ArmLine& arm, const Eigen::Matrix3Xd& positions) {
  const Eigen::Vector3d along = (arm.wrist - arm.shoulder).normalized();
  double radius = 0;
  for (const auto& at : positions.colwise()) radius = std::max(radius, along.cross(at - arm.shoulder).norm());
  return radius;
}

}  // namespace toile
