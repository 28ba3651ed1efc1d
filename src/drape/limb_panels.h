#pragma once
// Panels that belong to an arm: recognised by where a pattern puts them, rolled round the arm without stretching.

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "body/body.h"
#include "body/relative.h"
#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile {

// The straight line a sleeve is rolled round.
struct ArmLine {
  std::string name;  // "arm.L", "arm.R"
  Eigen::Vector3d shoulder, wrist;
  double to_finger_tips = 0;  // m along the line
};

std::vector<ArmLine> arm_lines(const Mannequin& form);

// A flat panel as its pattern places it.
struct FlatPanel {
  Eigen::Matrix3Xd positions;
  Eigen::Matrix3d axes;  // columns: the pattern's x and y axis and the outside, in the body's frame
};

// The arm whose line runs along the panel and through its middle; none for panels of the trunk or the legs.
std::optional<std::size_t> arm_of(const FlatPanel& panel, const std::vector<ArmLine>& arms, const Mannequin& form);

// Front and back panels of one arm, each bent isometrically to a part of a cylinder round the arm's line that is clear of the
// body and of the other panels of the arm. The pattern axis nearest to the line is turned into it, so that another pose than
// the one the pattern was placed for will do. `least`: m, radius at least.
std::vector<Eigen::Matrix3Xd> rolled_round(const ArmLine& arm, const std::vector<FlatPanel>& panels, const Body& body,
                                           double least = 0);

// m, farthest of some cloth from the arm's line.
double radius_round(const ArmLine& arm, const Eigen::Matrix3Xd& positions);

}  // namespace toile
