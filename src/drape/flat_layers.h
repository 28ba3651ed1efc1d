#pragma once
// Flat panels of outer layers: set outside those under them, and wide enough to be sewn round them.

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace toile {

// Panels from the body outwards, those of one layer in their own order.
std::vector<std::size_t> from_inside(const std::vector<int>& layer);

// Moves `x` straight along `outside` until it is clear of a panel under it that it would lie on.
void move_outside(const Eigen::Matrix3Xd& inner, const Eigen::Vector3d& outside, Eigen::Matrix3Xd& x);

// Factor, at least 1, by which panels of one layer are widened to both sides of x = 0 so that at every height they reach past
// the panels under them: their side seams then close outside them. They take their width when they are closed (SewOptions::
// unfold).
double widening(const std::vector<const Eigen::Matrix3Xd*>& inner, const std::vector<const Eigen::Matrix3Xd*>& outer);

// Widens a panel so. One that ends at the middle, such as half of a skirt or a trouser leg, is carried a little across it: the
// seam there closes outside what is under it too.
void widen(double factor, Eigen::Matrix3Xd& x);

}  // namespace toile
