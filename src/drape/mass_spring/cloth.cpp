#include "drape/mass_spring/cloth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "drape/fem/bending.h"
#include "geometry/topology.h"

namespace toile::mass_spring {
namespace {

BendingRows bending_rows(const std::vector<fem::Hinge>& hinges, int vertices) {
  std::vector<std::map<int, double>> rows(static_cast<std::size_t>(vertices));
  for (const fem::Hinge& hinge : hinges)
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        rows[static_cast<std::size_t>(hinge.vertex[i])][hinge.vertex[j]] += hinge.stiffness * hinge.weight[i] * hinge.weight[j];
  BendingRows bending;
  bending.first.push_back(0);
  for (const auto& row : rows) {
    double sum = 0;
    for (const auto& [column, value] : row) {
      bending.column.push_back(column);
      bending.value.push_back(value);
      sum += std::abs(value);
    }
    bending.first.push_back(static_cast<int>(bending.column.size()));
    bending.row_sum.push_back(sum);
  }
  return bending;
}

Eigen::Vector3d bending_pull(const BendingRows& bending, const Eigen::Matrix3Xd& x, std::size_t v) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = bending.first[v]; k < bending.first[v + 1]; ++k)
    sum += bending.value[static_cast<std::size_t>(k)] * x.col(bending.column[static_cast<std::size_t>(k)]);
  return sum;
}

double strain(const Spring& spring, const Eigen::Matrix3Xd& x) {
  return ((x.col(spring.b) - x.col(spring.a)).squaredNorm() / (spring.rest * spring.rest) - 1) / 2;
}

}  // namespace

Cloth make_cloth(const GarmentMesh& garment, const Fabric& fabric, const Body& body) {
  Cloth cloth;
  cloth.law.limit = fabric.most_stretch;
  cloth.springs = edge_springs(garment, fabric);
  cloth.bending = bending_rows(fem::bending_hinges(garment, fabric), garment.vertex_count);
  cloth.contact.friction = fabric.friction;
  cloth.body = &body;
  cloth.mass = Eigen::VectorXd::Zero(garment.vertex_count);
  const auto shapes = rest_triangles(garment);
  const Eigen::VectorXd layers = triangle_layers(garment);
  const Eigen::VectorXd areas = vertex_areas(garment);
  for (int v = 0; v < garment.vertex_count; ++v) cloth.samples.push_back({{v, v}, areas(v) / 4});
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    const auto corner = garment.triangles.col(t);
    const double area = std::abs(shapes[static_cast<std::size_t>(t)].determinant()) / 2;
    for (int i = 0; i < 3; ++i) cloth.mass(corner(i)) += fabric.area_density * layers(t) * area / 3;
  }
  for (const MeshEdge& edge : mesh_edges(garment.triangles)) {
    double area = 0;
    for (std::size_t s = 0; s < 2; ++s)
      if (is_new(edge, s)) area += std::abs(shapes[static_cast<std::size_t>(edge.triangle[s])].determinant()) / 2 / 4;
    cloth.samples.push_back({edge.vertex, area});
  }
  return cloth;
}

double weight(const Cloth& cloth) { return gravity * cloth.mass.norm(); }

double energy(const Cloth& cloth, const Eigen::Matrix3Xd& x) {
  double sum = 0;
  for (const Spring& spring : cloth.springs) sum += spring_energy(cloth.law, spring, x);
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    sum += x.col(v).dot(bending_pull(cloth.bending, x, static_cast<std::size_t>(v))) / 2 + gravity * cloth.mass(v) * x(1, v);
  for (const ContactSample& sample : cloth.samples) {
    const Eigen::Vector3d at = (x.col(sample.vertex[0]) + x.col(sample.vertex[1])) / 2;
    sum += fem::normal_energy(cloth.contact, sample.area, cloth.body->distance.distance(at));
  }
  return sum;
}

void add_inner_forces(const Cloth& cloth, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& force) {
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    force.col(v) -= bending_pull(cloth.bending, x, static_cast<std::size_t>(v));
    force(1, v) -= gravity * cloth.mass(v);
  }
  for (const Spring& spring : cloth.springs) {
    const Eigen::Vector3d pull = spring_force(cloth.law, spring, x);
    force.col(spring.a) += pull;
    force.col(spring.b) -= pull;
  }
}

Eigen::VectorXd row_sums(const Cloth& cloth, const Eigen::Matrix3Xd& x) {
  Eigen::VectorXd sums = Eigen::VectorXd::Map(cloth.bending.row_sum.data(), x.cols());
  for (const Spring& spring : cloth.springs) {
    const double e = std::max(0.0, strain(spring, x)) + 0.3 * cloth.law.limit;
    const Pull pull = pull_at(cloth.law, e);
    const double stiffness = 2 * spring.stiffness * (pull.slope * (1 + 2 * e) + pull.pull);
    sums(spring.a) += stiffness;
    sums(spring.b) += stiffness;
  }
  return sums;
}

double rest_row_sum(const Cloth& cloth) {
  double sum = 0;
  for (const double row : cloth.bending.row_sum) sum += row;
  for (const Spring& spring : cloth.springs) sum += 4 * spring.stiffness;
  return sum;
}

double static_residual(const Cloth& cloth, const Forces& forces) {
  double sum = 0;
  for (Eigen::Index v = 0; v < forces.total.cols(); ++v) {
    const Eigen::Vector3d force = forces.total.col(v);
    const double push = forces.push.col(v).norm();
    if (push <= 0) {
      sum += force.squaredNorm();
      continue;
    }
    const Eigen::Vector3d normal = forces.push.col(v) / push;
    const double across = normal.dot(force);
    const double along = std::max(0.0, (force - across * normal).norm() - cloth.contact.friction * push);
    sum += across * across + along * along;
  }
  return std::sqrt(sum) / weight(cloth);
}

}  // namespace toile::mass_spring
