#pragma once
// A tube of cloth on a tube of a body.

#include <cmath>
#include <numbers>

#include "garment/mannequin.h"
#include "garment/mesh.h"

namespace toile::test {

// A tube of `around` x `along` squares about the y axis, facing outwards.
inline void tube(double radius, double low, double high, int around, int along, Eigen::Matrix3Xd& positions,
                 Eigen::Matrix3Xi& triangles) {
  positions.resize(3, around * (along + 1));
  triangles.resize(3, 2 * around * along);
  Eigen::Index t = 0;
  for (int j = 0; j <= along; ++j)
    for (int i = 0; i < around; ++i) {
      const double turn = 2 * std::numbers::pi * i / around;
      positions.col(j * around + i) << radius * std::sin(turn), low + (high - low) * j / along, radius * std::cos(turn);
      if (j == along) continue;
      const int a = j * around + i, b = j * around + (i + 1) % around;
      triangles.col(t++) << a, b, b + around;
      triangles.col(t++) << a, b + around, a + around;
    }
}

struct Worn {
  Mannequin body;
  GarmentMesh garment;
  Eigen::Matrix3Xd drape;
};

// One panel round a tube of a body.
inline Worn worn() {
  Worn made;
  tube(.15, 0, 1.6, 24, 8, made.body.positions, made.body.triangles);
  tube(.17, .6, 1.0, 24, 6, made.drape, made.garment.triangles);
  made.garment.vertex_count = static_cast<int>(made.drape.cols());
  PanelMesh panel;
  panel.name = "tube";
  panel.rest = made.drape.topRows<2>();
  panel.triangles = made.garment.triangles;
  for (int i = 0; i < 24; ++i) panel.boundary.push_back({i, 0, i / 24.0});
  made.garment.panels = {panel};
  made.garment.welded = {Eigen::VectorXi::LinSpaced(made.drape.cols(), 0, static_cast<int>(made.drape.cols()) - 1)};
  return made;
}

}  // namespace toile::test
