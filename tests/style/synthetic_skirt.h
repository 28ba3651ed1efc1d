#pragma once
// A gored skirt on an elliptical body, both given by formulas, for tests of the style energy and of edits: tight down to the
// hip, then flared and folded. Irregular diagonals and jittered vertices, so that nothing depends on a regular mesh.

#include <Eigen/Core>

#include "garment/mannequin.h"
#include "garment/mesh.h"
#include "garment/pattern.h"

namespace toile::testing {

struct SkirtShape {
  int columns = 96, rows = 60, gores = 8;
  double waist_height = 1.05;  // m above the floor
  double length = 0.65;        // m, waist to hem
  double tight = 0.22;         // m below the waist, where the hip is
  double ease = 5e-3;          // m
  double flare = 0.25;         // radius per drop
  int folds = 9;
  double fold_depth = 0.02;  // m at the hem
  double jitter = 0.5;       // share of the mesh spacing
  bool named_edges = true;   // "hem", "waist", "side_left", "side_right"; otherwise "e0" .. "e3"
};

struct SyntheticSkirt {
  Pattern pattern;
  GarmentMesh garment;
  Eigen::Matrix3Xd drape;
  Mannequin form;
};

SyntheticSkirt synthetic_skirt(const SkirtShape& shape = {});

// Half width (x) and half depth (z) of the body `drop` metres below the waist.
Eigen::Vector2d body_section(const SkirtShape& shape, double drop);
// How far outside the body's elliptical section a point is, along its normal; m, negative inside. Not a distance near the ends.
double section_gap(const SkirtShape& shape, const Eigen::Vector3d& at);
Mannequin elliptical_body(const SkirtShape& shape);

}  // namespace toile::testing
