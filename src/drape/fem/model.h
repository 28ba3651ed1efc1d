#pragma once
// The energy that the fem simulator minimises: membrane + bending + weight + body contact + friction (anchored, normal forces
// lagged). One energy for every solver and every test.

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "body/body.h"
#include "drape/fem/bending.h"
#include "drape/fem/contact.h"
#include "drape/fem/membrane.h"
#include "drape/fem/sparse_spd.h"
#include "garment/mesh.h"

namespace toile::fem {

constexpr double gravity = 9.81;  // m/s^2, along -Y

// Where an edge of the mesh meets the body: its midpoint stands for `area`.
struct ContactEdge {
  std::array<int, 2> vertex{};
  double area = 0;  // m^2, rest
};

struct Model {
  MembraneLaw law;
  ContactLaw contact;
  std::vector<MembraneElement> triangles;
  std::vector<Hinge> hinges;
  Eigen::VectorXd mass;          // kg by vertex
  Eigen::VectorXd contact_area;  // m^2 by vertex: a quarter of its rest area; the rest is at the edges' midpoints
  std::vector<ContactEdge> contact_edges;
  const Body* body = nullptr;
  Eigen::Vector3d weight_direction = -Eigen::Vector3d::UnitY();
};

Model make_model(const GarmentMesh& garment, const Fabric& fabric, const Body& body);

// What is frozen while the energy is minimised: friction by vertex, anchors from the start.
struct Friction {
  std::vector<FrictionState> vertex;
  std::vector<char> touched;  // has been in contact: its anchor stands
};

// Anchors at `start`, for the vertices that touch there; others get theirs when they first touch.
Friction start_friction(const Model& model, const Eigen::Matrix3Xd& start);

// Moves the lagged normal forces by `share` towards those at `x` and takes the normals there. Returns the largest remaining
// difference of a force, N.
double update_friction(const Model& model, const Eigen::Matrix3Xd& x, double share, Friction& friction);

double energy(const Model& model, const Friction& friction, const Eigen::Matrix3Xd& x);  // J

// The gradient of the energy is the sum of both, N.
Eigen::Matrix3Xd gradient_without_friction(const Model& model, const Eigen::Matrix3Xd& x);
void add_friction(const Model& model, const Friction& friction, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& gradient);

// Pattern of the Hessian and its constant (bending) part.
struct HessianAssembly {
  BlockMatrix matrix;
  std::vector<double> constant;
};
std::unique_ptr<HessianAssembly> make_assembly(const Model& model);
// Fills assembly.matrix with the Hessian at x (no factorisation).
void assemble(const Model& model, const Friction& friction, const Eigen::Matrix3Xd& x, Curvature curvature,
              HessianAssembly& assembly);

double weight(const Model& model);  // N, norm of the gravity force vector over all vertices

}  // namespace toile::fem
