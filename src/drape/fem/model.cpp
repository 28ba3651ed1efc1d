#include "drape/fem/model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "parallel/threads.h"

namespace toile::fem {
namespace {

constexpr int energy_chunks = 16;

// Cloth bridges where the body is round, and sags deeper at the middle of an edge and of a triangle than at their corners: a
// quarter of its area is at the vertices, half at the edges, a quarter at the triangles.
std::vector<ContactSpot> contact_spots(const std::vector<MembraneElement>& triangles, const Eigen::VectorXd& at_vertices) {
  std::vector<ContactSpot> spots;
  for (int v = 0; v < static_cast<int>(at_vertices.size()); ++v) spots.push_back({1, {v}, at_vertices(v)});
  std::map<std::array<int, 2>, double> area;
  for (const MembraneElement& element : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = element.vertex[i], b = element.vertex[(i + 1) % 3];
      area[{std::min(a, b), std::max(a, b)}] += element.area / 6;
    }
  for (const auto& [vertex, sum] : area) spots.push_back({2, {vertex[0], vertex[1]}, sum});
  for (const MembraneElement& element : triangles) spots.push_back({3, element.vertex, element.area / 4});
  return spots;
}

}  // namespace

Model make_model(const GarmentMesh& garment, const Fabric& fabric, const Body& body) {
  Model model;
  model.law = membrane_law(fabric);
  model.contact = contact_law(fabric, body);
  model.self_contact.reach = replica_reach(model.self_contact.reach, fabric.thickness, body);
  const Eigen::VectorXd areas = vertex_areas(garment);
  model.contact_area = areas / 4;
  const Eigen::VectorXd layers = triangle_layers(garment);
  model.body = &body;
  model.hinges = bending_hinges(garment, fabric);
  model.bend_frictions = bend_frictions(garment, fabric, model.hinges);
  const auto shapes = rest_triangles(garment);
  model.mass = Eigen::VectorXd::Zero(garment.vertex_count);
  std::size_t t = 0;
  for (const PanelMesh& panel : garment.panels)
    for (Eigen::Index i = 0; i < panel.triangles.cols(); ++i, ++t) {
      const auto g = garment.triangles.col(static_cast<Eigen::Index>(t));
      MembraneElement element = membrane_element({g(0), g(1), g(2)}, shapes[t], panel.warp);
      element.layers = layers(static_cast<Eigen::Index>(t));
      for (int corner = 0; corner < 3; ++corner)
        model.mass(g(corner)) += fabric.area_density * element.layers * element.area / 3;
      model.triangles.push_back(element);
    }
  model.contact_spots = contact_spots(model.triangles, model.contact_area);
  model.cloth = collision_mesh(garment.triangles, static_cast<int>(garment.vertex_count));
  return model;
}

Frozen frozen_at(const Model& model, const Eigen::Matrix3Xd& start) {
  Frozen frozen;
  frozen.self.law = model.self_contact;
  frozen.vertex.resize(static_cast<std::size_t>(start.cols()));
  frozen.touched.assign(static_cast<std::size_t>(start.cols()), 0);
  update_friction(model, start, 1, frozen);
  for (const Hinge& hinge : model.hinges) frozen.bent.push_back(hinge_angle(hinge, start));
  return frozen;
}

double update_friction(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::VectorXd& forces, double share,
                       Frozen& frozen) {
  double rest = 0;
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    FrictionState& state = frozen.vertex[i];
    const double force = forces(v);
    if (force <= 0 && state.force <= 0) {
      frozen.touched[i] = 0;
      continue;
    }
    if (!frozen.touched[i]) {
      state.anchor = x.col(v);
      frozen.touched[i] = 1;
    }
    state.normal = model.body->distance.sample(x.col(v)).gradient.normalized();
    state.force += share * (force - state.force);
    if (force <= 0 && state.force < 1e-9) state.force = 0;
    rest = std::max(rest, std::abs(force - state.force));
  }
  return rest;
}

double update_friction(const Model& model, const Eigen::Matrix3Xd& x, double share, Frozen& frozen) {
  return update_friction(model, x, normal_forces(model, touching(model, x)), share, frozen);
}

double lasting_energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, const std::vector<Touch>& touches) {
  std::array<double, energy_chunks> part{};
  const auto share = [](int chunk, std::size_t count) {
    const auto c = static_cast<std::size_t>(chunk);
    return std::pair{count * c / energy_chunks, count * (c + 1) / energy_chunks};
  };
  in_ranges(energy_chunks, energy_chunks, [&](int chunk, int, int) {
    double sum = 0;
    const auto [first_triangle, last_triangle] = share(chunk, model.triangles.size());
    for (std::size_t t = first_triangle; t < last_triangle; ++t)
      sum += membrane_energy(model.triangles[t], model.law, corners_of(model.triangles[t], x));
    const auto [first_spring, last_spring] = share(chunk, model.springs.size());
    for (std::size_t s = first_spring; s < last_spring; ++s)
      sum += mass_spring::spring_energy(model.spring_law, model.springs[s], x);
    const auto [first_hinge, last_hinge] = share(chunk, model.hinges.size());
    for (std::size_t h = first_hinge; h < last_hinge; ++h) {
      sum += model.hinges[h].stiffness / 2 * hinge_vector(model.hinges[h], x).squaredNorm();
      sum += bend_friction_energy(model.bend_frictions[h], frozen.bent[h], model.hinges[h], x);
    }
    part[static_cast<std::size_t>(chunk)] = sum;
  });
  double sum = 0;
  for (const double p : part) sum += p;
  sum -= gravity * (model.weight_direction.transpose() * x).dot(model.mass);
  for (const Touch& touch : touches) sum += normal_energy(model.contact, touch.spot->area, touch.body.distance);
  return sum;
}

double lagged_energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x) {
  double sum = 0;
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    sum += friction_energy(model.contact, frozen.vertex[static_cast<std::size_t>(v)], x.col(v));
  return sum + self_contact_energy(frozen.self, x);
}

double energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x) {
  return lasting_energy(model, frozen, x, touching(model, x)) + lagged_energy(model, frozen, x);
}

void predict_pull(const Model& model, const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, Frozen& frozen) {
  frozen.pull.clear();
  for (const mass_spring::Spring& spring : model.springs) {
    const Eigen::Vector3d along = from.col(spring.b) - from.col(spring.a);
    const double square = along.dot(2 * (to.col(spring.b) - to.col(spring.a)) - along);
    frozen.pull.push_back(pull_at(model.spring_law, (square / (spring.rest * spring.rest) - 1) / 2).pull);
  }
}

SelfContact self_contact_at(const Model& model, NearPairSearch& search, const Eigen::Matrix3Xd& x) {
  SelfContact contact;
  contact.law = model.self_contact;
  for (const NearPair& pair : search.find(x)) {
    if (pair.distance <= 0 || pair.distance >= contact.law.reach) continue;
    const auto area = [&](std::size_t i) { return model.contact_area(pair.vertex[i]); };
    contact.pairs.push_back(pair);
    contact.area.push_back(pair.first == 1 ? area(0) : (area(0) + area(1) + area(2) + area(3)) / 4);
  }
  return contact;
}

namespace {

// Of weight, contact, membrane and bending, and of friction in the bends when `bent` is given.
Eigen::Matrix3Xd smooth_gradient(const Model& model, const std::vector<double>* bent, const Eigen::Matrix3Xd& x,
                                 const std::vector<Touch>& touches) {
  std::array<Eigen::Matrix3Xd, 2> half;  // of the triangles and hinges each, so that two threads can add
  in_ranges(2, 2, [&](int which, int, int) {
    const auto h = static_cast<std::size_t>(which);
    Eigen::Matrix3Xd& g = half[h];
    g.setZero(3, x.cols());
    for (std::size_t t = h * model.triangles.size() / 2; t < (h + 1) * model.triangles.size() / 2; ++t) {
      const MembraneElement& element = model.triangles[t];
      Vector9 local = Vector9::Zero();
      membrane_derivatives(element, model.law, corners_of(element, x), Curvature::full, local, nullptr);
      for (int i = 0; i < 3; ++i) g.col(element.vertex[static_cast<std::size_t>(i)]) += local.segment<3>(3 * i);
    }
    for (std::size_t s = h * model.springs.size() / 2; s < (h + 1) * model.springs.size() / 2; ++s) {
      const mass_spring::Spring& spring = model.springs[s];
      const Eigen::Vector3d force = mass_spring::spring_force(model.spring_law, spring, x);
      g.col(spring.a) -= force;
      g.col(spring.b) += force;
    }
    for (std::size_t e = h * model.hinges.size() / 2; e < (h + 1) * model.hinges.size() / 2; ++e) {
      const Hinge& hinge = model.hinges[e];
      const Eigen::Vector3d pull = hinge.stiffness * hinge_vector(hinge, x);
      Vector12 local;
      for (int i = 0; i < 4; ++i) local.segment<3>(3 * i) = hinge.weight[static_cast<std::size_t>(i)] * pull;
      if (bent) bend_friction_derivatives(model.bend_frictions[e], (*bent)[e], hinge, x, Curvature::full, local, nullptr);
      for (int i = 0; i < 4; ++i) g.col(hinge.vertex[static_cast<std::size_t>(i)]) += local.segment<3>(3 * i);
    }
  });
  half[0] += half[1];
  half[0] -= gravity * model.weight_direction * model.mass.transpose();
  for (const Touch& touch : touches) {
    const double share = normal_force(model.contact, touch.spot->area, touch.body.distance) / touch.spot->corners;
    for (const int v : corners_of(*touch.spot)) half[0].col(v) -= share * touch.body.gradient;
  }
  return std::move(half[0]);
}

}  // namespace

Eigen::Matrix3Xd gradient_without_friction(const Model& model, const Eigen::Matrix3Xd& x) {
  return smooth_gradient(model, nullptr, x, touching_sampled(model, x));
}

Eigen::Matrix3Xd lasting_gradient(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x,
                                  const std::vector<Touch>& touches) {
  return smooth_gradient(model, &frozen.bent, x, touches);
}

void add_friction(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& gradient) {
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    gradient.col(v) += friction_gradient(model.contact, frozen.vertex[static_cast<std::size_t>(v)], x.col(v));
  for (std::size_t h = 0; h < model.hinges.size(); ++h) {
    Vector12 local = Vector12::Zero();
    bend_friction_derivatives(model.bend_frictions[h], frozen.bent[h], model.hinges[h], x, Curvature::full, local, nullptr);
    for (int i = 0; i < 4; ++i) gradient.col(model.hinges[h].vertex[static_cast<std::size_t>(i)]) += local.segment<3>(3 * i);
  }
}

double weight(const Model& model) { return gravity * model.mass.norm(); }

}  // namespace toile::fem
