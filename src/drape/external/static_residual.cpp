#include "drape/external/static_residual.h"

#include <Eigen/Dense>
#include <cmath>

#include "drape/fem/model.h"

namespace toile::external {
namespace {

// What remains of a force on a vertex at rest when the body pushes along `normal` and friction holds, both as best they can:
// the distance of -force from the cone of reactions.
double out_of_cone(const Eigen::Vector3d& force, const Eigen::Vector3d& normal, double friction) {
  const double pressed = -force.dot(normal);
  const double along = (force + pressed * normal).norm();
  if (along <= friction * pressed) return 0;
  if (pressed <= 0 && friction * along <= -pressed) return force.norm();  // pulled off
  return (along - friction * pressed) / std::sqrt(1 + friction * friction);
}

}  // namespace

double static_residual(const DrapeRequest& request, const Eigen::Matrix3Xd& x, double touch) {
  fem::Model model = fem::make_model(request.garment, request.fabric, request.body);
  model.contact.pressure = 0;
  const Eigen::Matrix3Xd gradient = fem::gradient_without_friction(model, x);
  double sum = 0;
  for (Eigen::Index v = 0; v < x.cols(); ++v) {
    const Eigen::Vector3d force = -gradient.col(v);
    double left = force.norm();
    if (request.body.distance.distance(x.col(v)) < touch) {
      const Eigen::Vector3d out = request.body.distance.sample(x.col(v)).gradient;
      if (out.norm() > 0) left = out_of_cone(force, out.normalized(), request.fabric.friction);
    }
    sum += left * left;
  }
  return std::sqrt(sum) / fem::weight(model);
}

}  // namespace toile::external
