#include "measure/pressure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>
#include <vector>

#include "drape/fem/model.h"

namespace toile {
namespace {

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
  const Eigen::Matrix3Xd unbalanced = fem::gradient_without_friction(model, positions);

  const std::vector<char> lies = lying_on(body, garment.triangles, positions);
  Eigen::VectorXd push = Eigen::VectorXd::Zero(positions.cols());  // N
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    if (lies[static_cast<std::size_t>(v)])
      push(v) = unbalanced.col(v).dot(body.distance.sample(positions.col(v)).gradient.normalized());

  Eigen::VectorXd area = Eigen::VectorXd::Zero(positions.cols());  // as it hangs
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t) {
    const Eigen::Vector3i c = garment.triangles.col(t);
    const Eigen::Vector3d ab = positions.col(c(1)) - positions.col(c(0)), ac = positions.col(c(2)) - positions.col(c(0));
    for (int k = 0; k < 3; ++k) area(c(k)) += ab.cross(ac).norm() / 6;
  }

  // Every triangle gives its corners what lies on its two others, so that each neighbour counts about twice; so does the
  // vertex itself.
  Eigen::VectorXd push_around = 2 * push, area_around = 2 * area;
  for (Eigen::Index t = 0; t < garment.triangles.cols(); ++t)
    for (int k = 0; k < 3; ++k) {
      const int v = garment.triangles(k, t);
      for (const int other : {garment.triangles((k + 1) % 3, t), garment.triangles((k + 2) % 3, t)})
        push_around(v) += push(other), area_around(v) += area(other);
    }
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(positions.cols());
  for (Eigen::Index v = 0; v < positions.cols(); ++v)
    if (lies[static_cast<std::size_t>(v)] && area_around(v) > 0) pressure(v) = std::max(0.0, push_around(v) / area_around(v));
  return pressure;
}

}  // namespace toile
