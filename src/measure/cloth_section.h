#pragma once
// Where a plane cuts a garment, part by part.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "garment/mesh.h"

namespace toile {

// One connected part of a section, open or closed, in no order.
struct ClothSection {
  std::vector<std::array<Eigen::Vector3d, 2>> pieces;  // one for each triangle cut
  double at_rest = 0;                                  // m, length of it on the flat, unstretched cloth
};

// The plane goes through `at`, square to `normal`. `positions`: one column per garment vertex, m. Parts in the order of their
// first triangle.
std::vector<ClothSection> cloth_sections(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions,
                                         const Eigen::Vector3d& at, const Eigen::Vector3d& normal);

// Every ray in the plane from `centre` meets the section: it goes all round, closed or lapped.
bool goes_round(const ClothSection& section, const Eigen::Vector3d& centre, const Eigen::Vector3d& normal);

}  // namespace toile
