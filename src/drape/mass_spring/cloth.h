#pragma once
// The forces of the mass-spring cloth: springs, hinges (drape/fem/bending.h), weight, and the body's push, whose law is that of
// fem (drape/fem/contact.h), so that both simulators lie equally close to the body.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "body/body.h"
#include "drape/fem/contact.h"
#include "drape/mass_spring/springs.h"
#include "garment/mesh.h"

namespace toile::mass_spring {

constexpr double gravity = 9.81;  // m/s^2, along -Y

// Bending forces are -B x with one constant sparse matrix, row by row.
struct BendingRows {
  std::vector<int> first;  // by vertex, and the end
  std::vector<int> column;
  std::vector<double> value;    // N/m
  std::vector<double> row_sum;  // of absolute values
};

// A place where cloth feels the body: a vertex (both the same) or the middle of an edge, which sags deepest. With a quarter of
// the cloth at the vertices and the rest on the edges a quadratic pressure is summed exactly.
struct ContactSample {
  std::array<int, 2> vertex{};
  double area = 0;  // m^2
};

struct Cloth {
  SpringLaw law;
  std::vector<Spring> springs;
  BendingRows bending;
  Eigen::VectorXd mass;  // kg by vertex
  fem::ContactLaw contact;
  std::vector<ContactSample> samples;
  const Body* body = nullptr;
};

Cloth make_cloth(const GarmentMesh& garment, const Fabric& fabric, const Body& body);

double weight(const Cloth& cloth);  // N, norm of the gravity force vector over all vertices

// Forces and what limits the time step, at one shape.
struct Forces {
  Eigen::Matrix3Xd total;  // N, without friction
  Eigen::Matrix3Xd push;   // N, the body's share of it
};

// J; friction has none.
double energy(const Cloth& cloth, const Eigen::Matrix3Xd& x);

void add_inner_forces(const Cloth& cloth, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& force);  // springs, hinges, weight

// Sums of absolute values of the rows of the stiffness matrix of springs and hinges at `x`, N/m.
Eigen::VectorXd row_sums(const Cloth& cloth, const Eigen::Matrix3Xd& x);
// Of all rows, unstretched.
double rest_row_sum(const Cloth& cloth);

// Norm of the forces that are not balanced, friction taking up to friction * |push| of the tangential part, over the weight.
double static_residual(const Cloth& cloth, const Forces& forces);

}  // namespace toile::mass_spring
