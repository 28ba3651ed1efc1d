#pragma once
// The figures a pattern maker tapes on a fitting: garment girth, body girth and ease, level by level.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "body/body.h"
#include "garment/mesh.h"

namespace toile {

// Where a tape goes round the body: through `at`, in the plane with normal `along`.
struct GirthPlace {
  std::string name;                              // "bust", "waist", "hip", "biceps.L", "biceps.R", "thigh.L", "thigh.R"
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  // inside the limb, m
  Eigen::Vector3d along = Eigen::Vector3d::UnitY();
  std::string limb = "trunk";  // name of its axis (body/relative.h)
  double slide = 0;  // m, by how far the tape on the garment may go down, or out along an arm, until no other limb is in it
};

struct GirthRow {
  std::string name;
  double height = 0;          // m above the floor, where the body is taped
  double garment_height = 0;  // m, where the garment is: below that, or further out on an arm, where it has to slide
  double garment = 0;         // m, taut tape round the innermost layer of the garment; 0 when not covered
  double cloth = 0;           // m, that section of the cloth laid flat, unstretched: what the pattern measures there
  double body = 0;            // m, taut tape round the body
  double ease = 0;            // m, garment - body; 0 when not covered
  bool covered = false;       // the garment goes all round that limb there, and round no other
  bool operator==(const GirthRow&) const = default;
};

// Those of the list above that this body has: levels by its landmarks, biceps at .55 of the upper arm, across it, thigh 2 cm
// below the crotch, level. Bodies without bones have no biceps and thigh. At bust, biceps and thigh the tape on the garment
// slides by up to 6 cm to where sleeves and legs part from the rest, as a chest is measured below the armhole.
std::vector<GirthPlace> girth_places(const Mannequin& form);

GirthRow girth_row(const GirthPlace& place, const GarmentMesh& garment, const Eigen::Matrix3Xd& positions,
                   const Mannequin& form);

// A row for each of girth_places. `positions`: one column per garment vertex, m.
std::vector<GirthRow> girth_table(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Mannequin& form);

}  // namespace toile
