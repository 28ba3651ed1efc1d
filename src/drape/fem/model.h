#pragma once
// The energy that the simulators fem and mass-spring minimise: membrane or springs + bending + weight + body contact + friction
// on the body (anchored, normal forces lagged) and in the bent cloth (anchored) + contact of the cloth with itself (pairs and
// normals lagged). One energy for every solver and every test.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "body/body.h"
#include "drape/fem/bend_friction.h"
#include "drape/fem/bending.h"
#include "drape/fem/contact.h"
#include "drape/fem/membrane.h"
#include "drape/fem/self_contact.h"
#include "drape/fem/touching.h"
#include "drape/mass_spring/springs.h"
#include "garment/mesh.h"

namespace toile::fem {

constexpr double gravity = 9.81;  // m/s^2, along -Y

// Where the cloth may meet the body: a vertex, the midpoint of an edge or the centre of a triangle, by the number of its
// corners; it stands for `area`.
struct ContactSpot {
  int corners = 1;
  std::array<int, 3> vertex{};  // the first `corners`
  double area = 0;              // m^2, rest
};

struct Model {
  MembraneLaw law;
  ContactLaw contact;
  SelfContactLaw self_contact;
  std::vector<MembraneElement> triangles;  // none where springs take their place
  mass_spring::SpringLaw spring_law;
  std::vector<mass_spring::Spring> springs;
  std::vector<Hinge> hinges;
  std::vector<BendFriction> bend_frictions;  // by hinge
  Eigen::VectorXd mass;                      // kg by vertex
  Eigen::VectorXd contact_area;              // m^2 by vertex: the quarter of its rest area that touches at the vertex itself
  std::vector<ContactSpot> contact_spots;    // vertices, edges, triangles, each ascending
  CollisionMesh cloth;                       // what collides with itself
  const Body* body = nullptr;
  Eigen::Vector3d weight_direction = -Eigen::Vector3d::UnitY();
};

Model make_model(const GarmentMesh& garment, const Fabric& fabric, const Body& body);

// What is frozen while the energy is minimised: friction by vertex and by hinge, anchors from the start, and where the cloth
// touches itself.
struct Frozen {
  std::vector<FrictionState> vertex;
  std::vector<char> touched;  // has been in contact: its anchor stands
  std::vector<double> bent;   // rad, by hinge: the angle at the start
  SelfContact self;
  std::vector<double> pull;  // phi'(E) of each spring for the Hessian, or none: that of the shape
};

// Anchors at `start`, for the vertices that touch there; others get theirs when they first touch. No contact of the cloth with
// itself.
Frozen frozen_at(const Model& model, const Eigen::Matrix3Xd& start);

// Moves the lagged normal forces by `share` towards `forces` and takes the normals at `x`. Returns the largest remaining
// difference of a force, N.
double update_friction(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& forces, double share,
                       Frozen& frozen);
double update_friction(const Model& model, const Eigen::Matrix3Xd& x, double share, Frozen& frozen);

double energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x);  // J
// Its two parts: with what holds from the start on, and with what is frozen anew between steps. `touches`: at x.
double lasting_energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, const std::vector<Touch>& touches);
double lagged_energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x);

// Springs moved `from` `to` pull, as far as the Hessian is concerned, as if their strain had grown linearly: that they are
// longer for having been turned by a finite angle is an error of the step, not tension that would stiffen the next one
// (Magisano et al. 2017, "How to improve efficiency and robustness of the Newton method in geometrically non-linear structural
// problem discretized via displacement-based finite elements").
void predict_pull(const Model& model, const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, Frozen& frozen);

// What of the cloth is near to itself at `x`.
SelfContact self_contact_at(const Model& model, NearPairSearch& search, const Eigen::Matrix3Xd& x);

// The gradient of the energy is the sum of both, N.
Eigen::Matrix3Xd gradient_without_friction(const Model& model, const Eigen::Matrix3Xd& x);
void add_friction(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& gradient);
// The gradient of lasting_energy. `touches`: sampled at x.
Eigen::Matrix3Xd lasting_gradient(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x,
                                  const std::vector<Touch>& touches);

double weight(const Model& model);  // N, norm of the gravity force vector over all vertices

}  // namespace toile::fem
