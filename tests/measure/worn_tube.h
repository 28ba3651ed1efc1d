#pragma once
// A tube of cloth, one panel sewn to itself, round an upright round body: what it measures is known without a computer.

#include <cmath>
#include <numbers>

#include "body/body.h"
#include "body/tubes.h"
#include "garment/mesh.h"

namespace toile::test {

constexpr double pi = std::numbers::pi;

// Radius `radius` when not stretched, `length` long, `across` x `along` cells, warp upright.
inline GarmentMesh tube_of_cloth(double radius, double length, int across, int along) {
  PanelMesh panel;
  panel.name = "tube";
  panel.rest.resize(2, (across + 1) * (along + 1));
  panel.triangles.resize(3, 2 * across * along);
  GarmentMesh garment;
  garment.welded = {Eigen::VectorXi(panel.rest.cols())};
  // Chords and not arcs, so that the round tube of flat cells is exactly unstretched.
  const double cell = 2 * radius * std::sin(pi / across);
  Eigen::Index t = 0;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i <= across; ++i) {
      const int v = j * (across + 1) + i;
      panel.rest.col(v) << cell * i, length * j / along;
      garment.welded[0](v) = j * across + i % across;
      if (i == across || j == along) continue;
      const int up = v + across + 1;
      if ((i + j) % 2) {
        panel.triangles.col(t++) << v, v + 1, up + 1;
        panel.triangles.col(t++) << v, up + 1, up;
      } else {
        panel.triangles.col(t++) << v, v + 1, up;
        panel.triangles.col(t++) << v + 1, up + 1, up;
      }
    }
  const int row = across + 1;
  for (int i = 0; i < across; ++i) panel.boundary.push_back({i, 0, double(i) / across});
  for (int j = 0; j < along; ++j) panel.boundary.push_back({j * row + across, 1, double(j) / along});
  for (int i = across; i > 0; --i) panel.boundary.push_back({along * row + i, 2, double(across - i) / across});
  for (int j = along; j > 0; --j) panel.boundary.push_back({j * row, 3, double(along - j) / along});
  garment.vertex_count = across * (along + 1);
  garment.triangles = panel.triangles;
  for (Eigen::Index i = 0; i < garment.triangles.size(); ++i)
    garment.triangles.data()[i] = garment.welded[0](panel.triangles.data()[i]);
  garment.panels = {panel};
  return garment;
}

// Hanging round: radius, from `low` upwards, lengthened by the factor `longer`. Counter-clockwise seen from above, so that the
// right side is outside.
inline Eigen::Matrix3Xd worn_round(const GarmentMesh& garment, double radius, double low, double longer = 1,
                                   const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  Eigen::Matrix3Xd x(3, garment.vertex_count);
  const PanelMesh& panel = garment.panels[0];
  const double round = panel.rest.row(0).maxCoeff();
  for (Eigen::Index v = 0; v < panel.rest.cols(); ++v) {
    const double turn = 2 * pi * panel.rest(0, v) / round;
    x.col(garment.welded[0](v)) =
        middle + Eigen::Vector3d(radius * std::sin(turn), low + longer * panel.rest(1, v), radius * std::cos(turn));
  }
  return x;
}

inline Mannequin round_form(double radius, double height = 1.7, int across = 180) {
  Mannequin form;
  form.name = "cylinder";
  const Closed shape = cylinder({0, 0, 0}, {0, height, 0}, radius, across, 30);
  form.positions = shape.positions;
  form.triangles = shape.triangles;
  form.height = height;
  form.landmarks = {{"bust", 1.2}, {"waist", 1.0}, {"hip", .8}, {"crotch", .7}};
  return form;
}

inline Body body_of(const Mannequin& form) {
  return {form, DistanceField(form.positions, form.triangles), TriangleTree(form.positions, form.triangles)};
}

inline Body round_body(double radius) { return body_of(round_form(radius, 1.1)); }

}  // namespace toile::test
