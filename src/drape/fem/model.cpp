#include "drape/fem/model.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

namespace toile::fem {
namespace {

Eigen::Matrix3d corners(const MembraneElement& element, const Eigen::Matrix3Xd& x) {
  Eigen::Matrix3d c;
  for (int i = 0; i < 3; ++i) c.col(i) = x.col(element.vertex[static_cast<std::size_t>(i)]);
  return c;
}

// Edges bridge where the body is round, and sag deeper than faces: contact is kept at their midpoints as well as at the
// vertices (weights 3/4 and 1/4). Calls visit(midpoint, distance, edge) for midpoints within reach.
template <class Visit>
void for_edges_in_reach(const Model& model, const Eigen::Matrix3Xd& x, const Visit& visit) {
  for (const ContactEdge& edge : model.contact_edges) {
    const Eigen::Vector3d middle = (x.col(edge.vertex[0]) + x.col(edge.vertex[1])) / 2;
    const double distance = model.body->distance.distance(middle);
    if (distance < model.contact.reach) visit(middle, distance, edge);
  }
}

std::vector<ContactEdge> contact_edges(const std::vector<MembraneElement>& triangles) {
  std::map<std::array<int, 2>, double> area;
  for (const MembraneElement& element : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = element.vertex[i], b = element.vertex[(i + 1) % 3];
      area[{std::min(a, b), std::max(a, b)}] += 0.75 * element.area / 3;
    }
  std::vector<ContactEdge> edges;
  for (const auto& [vertex, sum] : area) edges.push_back({vertex, sum});
  return edges;
}

}  // namespace

Model make_model(const GarmentMesh& garment, const Fabric& fabric, const Body& body) {
  Model model;
  model.law = membrane_law(fabric);
  model.contact.friction = fabric.friction;
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
  model.contact_edges = contact_edges(model.triangles);
  model.cloth = collision_mesh(garment.triangles, static_cast<int>(garment.vertex_count));
  return model;
}

Frozen frozen_at(const Model& model, const Eigen::Matrix3Xd& start) {
  Frozen frozen;
  frozen.vertex.resize(static_cast<std::size_t>(start.cols()));
  frozen.touched.assign(static_cast<std::size_t>(start.cols()), 0);
  update_friction(model, start, 1, frozen);
  for (const Hinge& hinge : model.hinges) frozen.bent.push_back(hinge_angle(hinge, start));
  return frozen;
}

double update_friction(const Model& model, const Eigen::Matrix3Xd& x, double share, Frozen& frozen) {
  Eigen::VectorXd forces(x.cols());
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    forces(v) = normal_force(model.contact, model.contact_area(v), model.body->distance.distance(x.col(v)));
  for_edges_in_reach(model, x, [&](const Eigen::Vector3d&, double distance, const ContactEdge& edge) {
    for (const int v : edge.vertex) forces(v) += normal_force(model.contact, edge.area, distance) / 2;
  });
  double rest = 0;
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    FrictionState& state = frozen.vertex[i];
    const double force = forces(v);
    if (force <= 0 && state.force <= 0) {
      frozen.touched[i] = 0;
      continue;
    }
    const DistanceSample sample = model.body->distance.sample(x.col(v));
    if (!frozen.touched[i]) {
      state.anchor = x.col(v);
      frozen.touched[i] = 1;
    }
    state.normal = sample.gradient.normalized();
    state.force += share * (force - state.force);
    if (force <= 0 && state.force < 1e-9) state.force = 0;
    rest = std::max(rest, std::abs(force - state.force));
  }
  return rest;
}

double energy(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x) {
  double sum = 0;
  for (const MembraneElement& element : model.triangles) sum += membrane_energy(element, model.law, corners(element, x));
  for (std::size_t h = 0; h < model.hinges.size(); ++h) {
    sum += model.hinges[h].stiffness / 2 * hinge_vector(model.hinges[h], x).squaredNorm();
    sum += bend_friction_energy(model.bend_frictions[h], frozen.bent[h], model.hinges[h], x);
  }
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    sum -= gravity * model.mass(v) * model.weight_direction.dot(x.col(v));
    sum += normal_energy(model.contact, model.contact_area(v), model.body->distance.distance(x.col(v)));
    sum += friction_energy(model.contact, frozen.vertex[static_cast<std::size_t>(v)], x.col(v));
  }
  for_edges_in_reach(model, x, [&](const Eigen::Vector3d&, double distance, const ContactEdge& edge) {
    sum += normal_energy(model.contact, edge.area, distance);
  });
  return sum + self_contact_energy(frozen.self, x);
}

SelfContact self_contact_at(const Model& model, NearPairSearch& search, const Eigen::Matrix3Xd& x) {
  SelfContact contact;
  for (const NearPair& pair : search.find(x)) {
    if (pair.distance <= 0 || pair.distance >= contact.law.reach) continue;
    const auto area = [&](std::size_t i) { return model.contact_area(pair.vertex[i]); };
    contact.pairs.push_back(pair);
    contact.area.push_back(pair.first == 1 ? area(0) : (area(0) + area(1) + area(2) + area(3)) / 4);
  }
  return contact;
}

Eigen::Matrix3Xd gradient_without_friction(const Model& model, const Eigen::Matrix3Xd& x) {
  Eigen::Matrix3Xd g(3, x.cols());
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    g.col(v) = -gravity * model.mass(v) * model.weight_direction;
    const double distance = model.body->distance.distance(x.col(v));
    if (distance < model.contact.reach)
      g.col(v) -= normal_force(model.contact, model.contact_area(v), distance) * model.body->distance.sample(x.col(v)).gradient;
  }
  for_edges_in_reach(model, x, [&](const Eigen::Vector3d& middle, double distance, const ContactEdge& edge) {
    const Eigen::Vector3d push =
        normal_force(model.contact, edge.area, distance) / 2 * model.body->distance.sample(middle).gradient;
    for (const int v : edge.vertex) g.col(v) -= push;
  });
  for (const MembraneElement& element : model.triangles) {
    Vector9 local = Vector9::Zero();
    membrane_derivatives(element, model.law, corners(element, x), Curvature::full, local, nullptr);
    for (std::size_t i = 0; i < 3; ++i) g.col(element.vertex[i]) += local.segment<3>(static_cast<Eigen::Index>(3 * i));
  }
  for (const Hinge& hinge : model.hinges) {
    const Eigen::Vector3d pull = hinge.stiffness * hinge_vector(hinge, x);
    for (std::size_t i = 0; i < 4; ++i) g.col(hinge.vertex[i]) += hinge.weight[i] * pull;
  }
  return g;
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

std::unique_ptr<HessianAssembly> make_assembly(const Model& model, std::vector<std::pair<int, int>> coupled) {
  std::vector<std::pair<int, int>> pairs = std::move(coupled);
  for (const MembraneElement& e : model.triangles)
    for (std::size_t i = 0; i < 3; ++i) pairs.emplace_back(e.vertex[i], e.vertex[(i + 1) % 3]);
  for (const Hinge& h : model.hinges)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j) pairs.emplace_back(h.vertex[i], h.vertex[j]);
  std::unique_ptr<HessianAssembly> assembly(
      new HessianAssembly{BlockMatrix(static_cast<int>(model.mass.size()), std::move(pairs)), {}});
  for (const Hinge& h : model.hinges)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        assembly->matrix.add(h.vertex[i], h.vertex[j], h.stiffness * h.weight[i] * h.weight[j] * Eigen::Matrix3d::Identity());
  assembly->constant = assembly->matrix.values();
  return assembly;
}

void assemble(const Model& model, const Frozen& frozen, const Eigen::Matrix3Xd& x, Curvature curvature,
              HessianAssembly& assembly) {
  BlockMatrix& matrix = assembly.matrix;
  matrix.set_values(assembly.constant);
  for (const MembraneElement& element : model.triangles) {
    Vector9 ignored = Vector9::Zero();
    Matrix9 local = Matrix9::Zero();
    membrane_derivatives(element, model.law, corners(element, x), curvature, ignored, &local);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        matrix.add(element.vertex[i], element.vertex[j],
                   local.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j)));
  }
  for (std::size_t h = 0; h < model.hinges.size(); ++h) {
    if (model.bend_frictions[h].moment <= 0) continue;
    Vector12 ignored = Vector12::Zero();
    Matrix12 local = Matrix12::Zero();
    bend_friction_derivatives(model.bend_frictions[h], frozen.bent[h], model.hinges[h], x, curvature, ignored, &local);
    const auto& vertex = model.hinges[h].vertex;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j <= i; ++j)
        matrix.add(vertex[i], vertex[j], local.block<3, 3>(static_cast<Eigen::Index>(3 * i), static_cast<Eigen::Index>(3 * j)));
  }
  const auto contact_block = [&](const Eigen::Vector3d& at, double distance, double area) -> Eigen::Matrix3d {
    const DistanceSample sample = model.body->distance.sample(at);
    Eigen::Matrix3d block = normal_stiffness(model.contact, area, distance) * sample.gradient * sample.gradient.transpose();
    if (curvature == Curvature::full) block -= normal_force(model.contact, area, distance) * sample.hessian;
    return block;
  };
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    Eigen::Matrix3d block = friction_hessian(model.contact, frozen.vertex[static_cast<std::size_t>(v)], x.col(v));
    const double distance = model.body->distance.distance(x.col(v));
    if (distance < model.contact.reach) block += contact_block(x.col(v), distance, model.contact_area(v));
    matrix.add(static_cast<int>(v), static_cast<int>(v), block);
  }
  for_edges_in_reach(model, x, [&](const Eigen::Vector3d& middle, double distance, const ContactEdge& edge) {
    const Eigen::Matrix3d block = contact_block(middle, distance, edge.area) / 4;
    const auto [a, b] = edge.vertex;
    matrix.add(a, a, block);
    matrix.add(b, b, block);
    matrix.add(b, a, block);
  });
  add_self_contact(frozen.self, x, matrix);
}

double weight(const Model& model) { return gravity * model.mass.norm(); }

}  // namespace toile::fem
