#pragma once
// E_shape of the style energy (Brouet et al. 2012 by way of Bartle et al. 2016, Sec. 3): how far a target garment's triangles
// tilt out of the planes they had in the source drape. The Sumner-Popovic frames of the original have a fourth vertex that only
// ever absorbs the normal; without it the term is
//   E_shape(x) = sum_t A_t || J_t(x) - B_t M_t ||_F^2,   J_t(x) = sum_i x_i g_ti^T,
// with B_t the plane of the source triangle and M_t (2x2) the in-plane map of the last iterate, frozen.

#include <Eigen/Core>
#include <vector>

namespace toile {

struct SourceTriangle {
  Eigen::Vector3i corners;
  Eigen::Matrix<double, 3, 2> plane;      // B: orthonormal basis of the source plane
  Eigen::Matrix<double, 3, 2> gradients;  // row i: gradient of corner i's hat function in that basis, 1/m
  double area = 0;                        // m^2
};

// One per triangle that has any area; slivers without one are left out.
std::vector<SourceTriangle> source_triangles(const Eigen::Matrix3Xd& source, const Eigen::Matrix3Xi& triangles);

// A third of the area of the triangles round each vertex, m^2.
Eigen::VectorXd vertex_areas(const std::vector<SourceTriangle>& triangles, Eigen::Index vertex_count);

// J_t(x): the linear map from the source plane to where the triangle is now.
Eigen::Matrix<double, 3, 2> map_of(const SourceTriangle& triangle, const Eigen::Matrix3Xd& x);

// B^T J(x): its part in the source plane.
Eigen::Matrix2d plane_map_of(const SourceTriangle& triangle, const Eigen::Matrix3Xd& x);

// `map` with its singular values (signed: the smaller is negative when the map turns the triangle over) moved into
// [least, most]; untouched when they are there already. 0 < least <= most.
Eigen::Matrix2d clamped(const Eigen::Matrix2d& map, double least, double most);

// Larger first; the smaller is negative when `map` turns over.
Eigen::Vector2d signed_singular_values(const Eigen::Matrix2d& map);

// The sum above, m^2. maps[t] is M_t.
double shape_energy(const std::vector<SourceTriangle>& triangles, const std::vector<Eigen::Matrix2d>& maps,
                    const Eigen::Matrix3Xd& x);
// Its gradient by vertex, m.
Eigen::Matrix3Xd shape_gradient(const std::vector<SourceTriangle>& triangles, const std::vector<Eigen::Matrix2d>& maps,
                                const Eigen::Matrix3Xd& x);
// The least of it over all maps: sum_t A_t |n_t^T J_t(x)|^2, tilt alone.
double tilt_energy(const std::vector<SourceTriangle>& triangles, const Eigen::Matrix3Xd& x);

}  // namespace toile
