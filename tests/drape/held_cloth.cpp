#include "held_cloth.h"

#include <algorithm>

#include "drape/fem/assembly.h"

namespace toile::test {

HeldCloth settle_held(const fem::Model& model, const Eigen::Matrix3Xd& start, const std::vector<int>& held, double tolerance) {
  const fem::Frozen nothing = fem::frozen_at(model, start);
  const auto assembly = fem::make_assembly(model);
  const double load = fem::weight(model), typical_mass = model.mass.mean();
  HeldCloth out{start, {}, 0, 0};
  double dt = .02;
  for (; out.steps < 400; ++out.steps) {
    out.reaction = fem::gradient_without_friction(model, out.x);
    Eigen::Matrix3Xd force = out.reaction;
    for (const int v : held) force.col(v).setZero();
    out.residual = force.norm() / load;
    if (out.residual < tolerance) break;
    const auto factorised = [&](fem::Curvature curvature) {
      fem::assemble(model, nothing, out.x, curvature, *assembly);
      for (int v = 0; v < static_cast<int>(model.mass.size()); ++v) assembly->matrix.add_diagonal(v, typical_mass / (dt * dt));
      for (const int v : held) assembly->matrix.add_diagonal(v, 1e9);
      return assembly->matrix.factorise();
    };
    if (!factorised(fem::Curvature::full) && !factorised(fem::Curvature::clamped)) {
      dt /= 4;
      continue;
    }
    Eigen::Matrix3Xd move = -assembly->matrix.solve(force);
    for (const int v : held) move.col(v).setZero();
    const double longest = move.colwise().norm().maxCoeff();
    if (longest > .02) move *= .02 / longest;
    const double slope = force.cwiseProduct(move).sum(), before = fem::energy(model, nothing, out.x);
    double fraction = 1;
    while (fraction > 1e-4 && fem::energy(model, nothing, out.x + fraction * move) > before + 1e-4 * fraction * slope &&
           fraction * longest > 1e-9)
      fraction /= 2;
    out.x += fraction * move;
    dt = fraction > .2 ? std::min(2 * dt, 1e3) : std::max(dt / 2, 1e-3);
  }
  return out;
}

}  // namespace toile::test
