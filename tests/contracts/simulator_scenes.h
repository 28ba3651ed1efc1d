#pragma once
// Cloths and bodies for which the drape is known without a simulator.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "body/body.h"
#include "body/tubes.h"
#include "garment/mesh.h"

namespace toile::test {

// One panel `width` x `length` about the origin, warp along its length (+y): square cells with both diagonals.
inline GarmentMesh crossed_sheet(double width, double length, int columns) {
  const double step = width / columns;
  const int rows = static_cast<int>(std::lround(length / step));
  std::vector<Eigen::Vector2d> points;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) points.emplace_back(i * step - width / 2, j * step - length / 2);
  std::vector<Eigen::Vector3i> faces;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1, m = static_cast<int>(points.size());
      points.emplace_back((i + .5) * step - width / 2, (j + .5) * step - length / 2);
      for (const auto& face :
           {Eigen::Vector3i(a, b, m), Eigen::Vector3i(b, c, m), Eigen::Vector3i(c, d, m), Eigen::Vector3i(d, a, m)})
        faces.push_back(face);
    }
  PanelMesh panel;
  panel.name = "sheet";
  panel.rest.resize(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) panel.rest.col(static_cast<Eigen::Index>(i)) = points[i];
  panel.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i) panel.triangles.col(static_cast<Eigen::Index>(i)) = faces[i];
  GarmentMesh garment;
  garment.vertex_count = static_cast<int>(points.size());
  garment.triangles = panel.triangles;
  garment.welded = {Eigen::VectorXi::LinSpaced(garment.vertex_count, 0, garment.vertex_count - 1)};
  garment.panels = {panel};
  return garment;
}

// Without what make_body asks of a person.
inline Body body_of(const Closed& shape, const char* name) {
  Mannequin form;
  form.name = name;
  form.positions = shape.positions;
  form.triangles = shape.triangles;
  return {form, DistanceField(form.positions, form.triangles), TriangleTree(form.positions, form.triangles)};
}

// The frame of a table top about (0, 1, 0) that falls by `angle` towards +Z: columns are across, down the slope, and out.
inline Eigen::Matrix3d slope_frame(double angle) {
  Eigen::Matrix3d frame;
  frame << Eigen::Vector3d::UnitX(), Eigen::Vector3d(0, -std::sin(angle), std::cos(angle)),
      Eigen::Vector3d(0, std::cos(angle), std::sin(angle));
  return frame;
}

inline Body table(double angle = 0) {
  const Eigen::Matrix3d frame = slope_frame(angle);
  Closed top = box({0, -.05, 0}, {.25, .05, .25});
  Eigen::Matrix3d turn;
  turn << frame.col(0), frame.col(2), frame.col(1);
  top.positions = (turn * top.positions).colwise() + Eigen::Vector3d(Eigen::Vector3d::UnitY());
  return body_of(top, "table");
}

// On that table top, `above` it, right side out.
inline Eigen::Matrix3Xd laid_on(const GarmentMesh& sheet, double angle, double above) {
  Eigen::Matrix3Xd x(3, sheet.vertex_count);
  const Eigen::Matrix3d frame = slope_frame(angle);
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    x.col(v) =
        Eigen::Vector3d::UnitY() + frame * Eigen::Vector3d(sheet.panels[0].rest(0, v), -sheet.panels[0].rest(1, v), above);
  return x;
}

constexpr double bar_radius = .04;

// A level rod along X through (0, 1, 0).
inline Body bar() { return body_of(cylinder({-.1, 1, 0}, {.1, 1, 0}, bar_radius, 96, 8), "bar"); }

// Hung over the rod by its middle, both ends straight down.
inline Eigen::Matrix3Xd hung_over_bar(const GarmentMesh& sheet) {
  const double radius = bar_radius + .95e-3, quarter = radius * std::numbers::pi / 2;
  Eigen::Matrix3Xd x(3, sheet.vertex_count);
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const double s = -sheet.panels[0].rest(1, v), round = std::clamp(s, -quarter, quarter);
    x.col(v) << sheet.panels[0].rest(0, v), 1 + radius * std::cos(round / radius) - (std::abs(s) - std::abs(round)),
        radius * std::sin(round / radius);
  }
  return x;
}

}  // namespace toile::test
