#include "drape/fem/membrane.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace toile::fem {
namespace {

struct Stress {
  double energy = 0;                                  // per area
  Eigen::Vector3d stress = Eigen::Vector3d::Zero();   // S11, S22, S12
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();  // d(S11, S22, S12) / d(E11, E22, 2 E12)
};

// Beyond the limit the stiffness grows linearly with the excess strain: ten times the fabric's at twice the limit. Cubic, so
// C2.
void stiffen(double strain, double modulus, double limit, double& energy, double& stress, double& tangent) {
  const double excess = strain - limit;
  if (excess <= 0) return;
  const double k = 10 * modulus / limit;
  energy += k * excess * excess * excess / 6;
  stress += k * excess * excess / 2;
  tangent += k * excess;
}

// Squeezed by more than `crumple_strain`, as where a longer edge is gathered into a shorter one, cloth wrinkles finer than any
// mesh shows: the stiffness falls smoothly to that of the wrinkled cloth. Taken off the linear law; C2.
constexpr double crumple_strain = 0.02;
constexpr double crumple_width = 0.02;

void crumple(double strain, double modulus, double left, double& energy, double& stress, double& tangent) {
  const double u = -strain - crumple_strain;
  if (u <= 0) return;
  const double k = modulus - left;
  if (u < crumple_width) {
    energy -= k * u * u * u / (6 * crumple_width);
    stress += k * u * u / (2 * crumple_width);
    tangent -= k * u / crumple_width;
  } else {
    const double v = u - crumple_width / 2;
    energy -= k * (v * v / 2 + crumple_width * crumple_width / 24);
    stress += k * v;
    tangent -= k;
  }
}

Stress stress_of(const MembraneLaw& law, double e11, double e22, double g12) {
  Stress s;
  s.stress << law.c11 * e11 + law.c12 * e22, law.c12 * e11 + law.c22 * e22, law.c66 * g12;
  s.energy = (s.stress(0) * e11 + s.stress(1) * e22 + s.stress(2) * g12) / 2;
  s.tangent << law.c11, law.c12, 0, law.c12, law.c22, 0, 0, 0, law.c66;
  stiffen(e11, law.c11, law.limit, s.energy, s.stress(0), s.tangent(0, 0));
  stiffen(e22, law.c22, law.limit, s.energy, s.stress(1), s.tangent(1, 1));
  // The coupling term bounds from below what leaves the law convex.
  const double least = 1.5 * law.c12;
  crumple(e11, law.c11, std::min(law.c11, std::max(0.15 * law.c11, least)), s.energy, s.stress(0), s.tangent(0, 0));
  crumple(e22, law.c22, std::min(law.c22, std::max(0.15 * law.c22, least)), s.energy, s.stress(1), s.tangent(1, 1));
  return s;
}

Stress stress_at(const MembraneLaw& law, const Eigen::Matrix<double, 3, 2>& f) {
  const double e11 = (f.col(0).squaredNorm() - 1) / 2;
  const double e22 = (f.col(1).squaredNorm() - 1) / 2;
  return stress_of(law, e11, e22, f.col(0).dot(f.col(1)));
}

// Nearest positive semidefinite 2x2 matrix to the stress.
Eigen::Matrix2d tension_part(const Eigen::Matrix2d& s) {
  const double mean = (s(0, 0) + s(1, 1)) / 2;
  const double radius = std::hypot((s(0, 0) - s(1, 1)) / 2, s(0, 1));
  const double high = mean + radius;
  const double low = mean - radius;
  if (low >= 0) return s;
  if (high <= 0) return Eigen::Matrix2d::Zero();
  return high / (high - low) * (s - low * Eigen::Matrix2d::Identity());
}

}  // namespace

MembraneElement membrane_element(const std::array<int, 3>& vertex, const Eigen::Matrix2d& rest_edges,
                                 const Eigen::Vector2d& warp) {
  Eigen::Matrix2d frame;
  frame << warp.transpose(), -warp.y(), warp.x();
  const Eigen::Matrix2d inverse = (frame * rest_edges).inverse();
  MembraneElement element;
  element.vertex = vertex;
  element.area = std::abs(rest_edges.determinant()) / 2;
  element.gradient.col(1) = inverse.row(0).transpose();
  element.gradient.col(2) = inverse.row(1).transpose();
  element.gradient.col(0) = -element.gradient.col(1) - element.gradient.col(2);
  return element;
}

MembraneLaw membrane_law(const Fabric& fabric) {
  return {fabric.stretch_warp, fabric.stretch_weft, fabric.stretch_cross, fabric.shear, fabric.most_stretch};
}

Eigen::Matrix3d corners_of(const MembraneElement& element, const Eigen::Matrix3Xd& x) {
  Eigen::Matrix3d corners;
  for (int i = 0; i < 3; ++i) corners.col(i) = x.col(element.vertex[static_cast<std::size_t>(i)]);
  return corners;
}

double membrane_energy(const MembraneElement& element, const MembraneLaw& law, const Eigen::Matrix3d& x) {
  const Eigen::Matrix<double, 3, 2> f = x * element.gradient.transpose();
  return element.layers * element.area * stress_at(law, f).energy;
}

double membrane_derivatives(const MembraneElement& element, const MembraneLaw& law, const Eigen::Matrix3d& x,
                            Curvature curvature, Vector9& gradient, Matrix9* hessian) {
  const Eigen::Matrix<double, 3, 2> f = x * element.gradient.transpose();
  const Stress s = stress_at(law, f);
  const double cloth = element.layers * element.area;
  Eigen::Matrix2d tensor;
  tensor << s.stress(0), s.stress(2), s.stress(2), s.stress(1);

  // Rows: derivative of (E11, E22, 2 E12) with respect to the nine corner coordinates.
  Eigen::Matrix<double, 3, 9> strain;
  for (int i = 0; i < 3; ++i) {
    const double b1 = element.gradient(0, i);
    const double b2 = element.gradient(1, i);
    strain.block<1, 3>(0, 3 * i) = b1 * f.col(0).transpose();
    strain.block<1, 3>(1, 3 * i) = b2 * f.col(1).transpose();
    strain.block<1, 3>(2, 3 * i) = b1 * f.col(1).transpose() + b2 * f.col(0).transpose();
  }
  gradient.noalias() += cloth * (strain.transpose() * s.stress);
  if (hessian) {
    hessian->noalias() += cloth * (strain.transpose() * s.tangent * strain);
    const Eigen::Matrix2d held = curvature == Curvature::full ? tensor : tension_part(tensor);
    const Eigen::Matrix3d geometric = cloth * (element.gradient.transpose() * held * element.gradient);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k) (*hessian)(3 * i + k, 3 * j + k) += geometric(i, j);
  }
  return cloth * s.energy;
}

}  // namespace toile::fem
