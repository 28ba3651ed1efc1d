#pragma once
// A panel laid into a given boundary.

#include <Eigen/Core>
#include <vector>

namespace toile {

struct LaidPanel {
  Eigen::Matrix2Xd at;
  int inverted = 0;  // triangles that could not be kept counter-clockwise
};

// Positions with boundary[i] at targets.col(i) and the other vertices such that the triangles are as rigid as possible to their
// shape in `like` (ARAP, local/global with hard constraints), none inverted. `fallback`: shapes to take when `like` has
// inverted triangles itself. Triangles are counter-clockwise.
LaidPanel lay_panel(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix2Xd& like, const Eigen::Matrix2Xd& fallback,
                    const std::vector<int>& boundary, const Eigen::Matrix2Xd& targets);

}  // namespace toile
