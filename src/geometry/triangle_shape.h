#pragma once
// The 2D shape of a triangle, free of place and orientation (paper Sec. 4, Setup).

#include <Eigen/Core>

namespace toile {

// The triangle with its first corner at the origin and its first edge on the x axis: columns are the edges b - a and c - a,
// i.e. [[|u|, |v| cos], [0, |v| sin]]. (The paper's footnote 1 prints sine and cosine of v exchanged.)
Eigen::Matrix2d triangle_shape(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
Eigen::Matrix2d triangle_shape(const Eigen::Matrix2d& edges);  // columns b - a, c - a in 2D; keeps orientation

// T^{k+1} = T^k (t^k)^-1 t^g: undo, in the rest shape, what draping did to it. Eq. 6-7.
Eigen::Matrix2d next_rest(const Eigen::Matrix2d& rest, const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal);

// Singular values of t^g (t^k)^-1, larger first.
Eigen::Vector2d stretch_values(const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal);

// S of Eq. 8. With singular values: the eigenvalues the paper prints depend on which corner starts the triangle.
double stretch_agreement(const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal);
// S of Eq. 8 as it is printed, from triangle_shape's matrices: their eigenvalues, which shear does not change.
double printed_agreement(const Eigen::Matrix2d& draped, const Eigen::Matrix2d& goal);

}  // namespace toile
