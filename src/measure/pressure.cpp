#include "measure/pressure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "drape/fem/model.h"

namespace toile {
namespace {

// What of a triangle is nearest to each of its corners (Meyer et al. 2003, Fig. 4): the forces of evenly stretched cloth are in
// proportion to it however the triangles lie, as they are not to thirds.
Eigen::Vector3d corner_areas(const Eigen::Matrix3d& corners) {
  const Eigen::Vector3d ab = corners.col(1) - corners.col(0), ac = corners.col(2) - corners.col(0);
  const double area = ab.cross(ac).norm() / 2;
  if (!(area > 0)) return Eigen::Vector3d::Zero();
  Eigen::Vector3d opposite, cotangent;  // squared length of the edge opposite to a corner; of the angle there
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3d to_next = corners.col((k + 1) % 3) - corners.col(k),
                          to_last = corners.col((k + 2) % 3) - corners.col(k);
    if (to_next.dot(to_last) < 0) {
      Eigen::Vector3d areas = Eigen::Vector3d::Constant(area / 4);
      areas(k) = area / 2;
      return areas;
    }
    opposite(k) = (to_next - to_last).squaredNorm();
    cotangent(k) = to_next.dot(to_last) / (2 * area);
  }
  const Eigen::Vector3d edge = opposite.cwiseProduct(cotangent) / 8;
  return Eigen::Vector3d::Constant(edge.sum()) - edge;
}

// kg by vertex, by the areas of the rest shape.
Eigen::VectorXd weights(const fem::Model& model, const std::vector<Eigen::Matrix2d>& rest, const Fabric& fabric) {
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(model.mass.size());
  for (std::size_t t = 0; t < rest.size(); ++t) {
    Eigen::Matrix3d corners = Eigen::Matrix3d::Zero();
    corners.topRightCorner<2, 2>() = rest[t];
    const Eigen::Vector3d areas = corner_areas(corners);
    for (std::size_t k = 0; k < 3; ++k)
      mass(model.triangles[t].vertex[k]) +=
          fabric.area_density * model.triangles[t].layers * areas(static_cast<Eigen::Index>(k));
  }
  return mass;
}

// Whether the cloth at a vertex lies on the body: itself or the middle of an edge there.
std::vector<char> lying_on(const Body& body, const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& positions) {
  std::vector<char> lies(static_cast<std::size_t>(positions.cols()), 0);
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    lies[static_cast<std::size_t>(v)] = body.distance.distance(positions.col(v)) < touching;
  for (Eigen::Index t = 0; t < triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(triangles(k, t)), b = static_cast<std::size_t>(triangles((k + 1) % 3, t));
      if (lies[a] && lies[b]) continue;
      const Eigen::Vector3d middle =
          (positions.col(static_cast<Eigen::Index>(a)) + positions.col(static_cast<Eigen::Index>(b))) / 2;
      if (body.distance.distance(middle) < touching) lies[a] = lies[b] = 1;
    }
  return lies;
}

}  // namespace

Eigen::VectorXd body_pressure(const GarmentMesh& garment, const Eigen::Matrix3Xd& positions, const Body& body,
                              const Fabric& fabric) {
  if (positions.cols() != garment.vertex_count) throw std::invalid_argument("body_pressure: one position per garment vertex");
  fem::Model model = fem::make_model(garment, fabric, body);
  model.contact.pressure = 0;  // what is left without the body's push is what it has to push against
  model.mass = weights(model, rest_triangles(garment), fabric);
  const Eigen::Matrix3Xd unbalanced = fem::gradient_without_friction(model, positions);

  const std::vector<char> lies = lying_on(body, garment.triangles, positions);
  Eigen::VectorXd push = Eigen::VectorXd::Zero(positions.cols());  // N
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    if (lies[static_cast<std::size_t>(v)])
      push(v) = unbalanced.col(v).dot(body.distance.sample(positions.col(v)).gradient.normalized());

  Eigen::Matrix3Xd share(3, garment.triangles.cols());  // m^2 by triangle and corner, as it hangs
  Eigen::VectorXd area = Eigen::VectorXd::Zero(positions.cols());
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    const Eigen::Vector3i c = garment.triangles.col(t);
    Eigen::Matrix3d corners;
    corners << positions.col(c(0)), positions.col(c(1)), positions.col(c(2));
    share.col(t) = corner_areas(corners);
    for (int k = 0; k < 3; ++k) area(c(k)) += share(k, t);
  }

  // From the vertices to the triangles and back: even, and no force is lost.
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(positions.cols());  // N
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    double force = 0;
    for (int k = 0; k < 3; ++k)
      if (const int v = garment.triangles(k, t); area(v) > 0) force += push(v) * share(k, t) / area(v);
    if (const double whole = share.col(t).sum(); whole > 0)
      for (int k = 0; k < 3; ++k) sum(garment.triangles(k, t)) += force * share(k, t) / whole;
  }
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(positions.cols());
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    if (lies[static_cast<std::size_t>(v)] && area(v) > 0) pressure(v) = std::max(0.0, sum(v) / area(v));
  return pressure;
}

}  // namespace toile
