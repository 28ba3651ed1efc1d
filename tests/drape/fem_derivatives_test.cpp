#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "drape/fem/contact.h"
#include "drape/fem/membrane.h"

namespace toile::fem {
namespace {

const Fabric jersey{
    .name = "test", .stretch_warp = 300, .stretch_weft = 200, .stretch_cross = 60, .shear = 80, .most_stretch = .1};

MembraneElement element() {
  Eigen::Matrix2d edges;
  edges << .012, .003, .001, .011;
  return membrane_element({0, 1, 2}, edges, Eigen::Vector2d(.6, .8));
}

// A stretched, sheared and turned state, past the stretch limit in one direction; or a compressed one.
Eigen::Matrix3d state(double stretch) {
  Eigen::Matrix3d x;
  x.col(0) << .1, .2, .3;
  x.col(1) << .1 + .012 * stretch, .2002, .302;
  x.col(2) << .103, .2 + .004, .3 + .0105 * stretch;
  return x;
}

class Membrane : public testing::TestWithParam<double> {};

TEST_P(Membrane, GradientIsTheDifferenceQuotientOfTheEnergy) {
  const auto law = membrane_law(jersey);
  const Eigen::Matrix3d x = state(GetParam());
  Vector9 g = Vector9::Zero();
  const double energy = membrane_derivatives(element(), law, x, Curvature::full, g, nullptr);
  EXPECT_NEAR(energy, membrane_energy(element(), law, x), 1e-15);
  const double h = 1e-7;
  for (int i = 0; i < 9; ++i) {
    Eigen::Matrix3d plus = x, minus = x;
    plus(i % 3, i / 3) += h;
    minus(i % 3, i / 3) -= h;
    const double quotient = (membrane_energy(element(), law, plus) - membrane_energy(element(), law, minus)) / (2 * h);
    EXPECT_NEAR(g(i), quotient, 1e-6 * g.cwiseAbs().maxCoeff()) << i;
  }
}

TEST_P(Membrane, HessianIsTheDifferenceQuotientOfTheGradient) {
  const auto law = membrane_law(jersey);
  const Eigen::Matrix3d x = state(GetParam());
  Vector9 g = Vector9::Zero();
  Matrix9 hessian = Matrix9::Zero();
  membrane_derivatives(element(), law, x, Curvature::full, g, &hessian);
  const double h = 1e-7;
  for (int i = 0; i < 9; ++i) {
    Eigen::Matrix3d plus = x, minus = x;
    plus(i % 3, i / 3) += h;
    minus(i % 3, i / 3) -= h;
    Vector9 above = Vector9::Zero(), below = Vector9::Zero();
    membrane_derivatives(element(), law, plus, Curvature::full, above, nullptr);
    membrane_derivatives(element(), law, minus, Curvature::full, below, nullptr);
    EXPECT_TRUE(hessian.col(i).isApprox((above - below) / (2 * h), 1e-5)) << i;
  }
}

TEST_P(Membrane, ClampedHessianHasNoNegativeEigenvalue) {
  Vector9 g = Vector9::Zero();
  Matrix9 hessian = Matrix9::Zero();
  membrane_derivatives(element(), membrane_law(jersey), state(GetParam()), Curvature::clamped, g, &hessian);
  const Eigen::SelfAdjointEigenSolver<Matrix9> solver(hessian);
  EXPECT_GE(solver.eigenvalues().minCoeff(), -1e-9 * solver.eigenvalues().maxCoeff());
}

INSTANTIATE_TEST_SUITE_P(States, Membrane, testing::Values(.8, 1.0, 1.05, 1.3));

TEST(MembraneEnergy, VanishesUnderRigidMotion) {
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  Eigen::Matrix3d x = Eigen::Matrix3d::Zero();
  x.block<2, 1>(0, 1) << .012, .001;
  x.block<2, 1>(0, 2) << .003, .011;
  x = (turn * x).colwise() + Eigen::Vector3d(1, 2, 3);
  EXPECT_LT(membrane_energy(element(), membrane_law(jersey), x), 1e-20);
}

TEST(Contact, ForceAndStiffnessAreDerivativesOfTheEnergy) {
  const ContactLaw law;
  const double area = 1e-4, h = 1e-8;
  for (const double d : {-4e-4, -2e-4, 1e-4, 4e-4, 6e-4, 9e-4, 2e-3}) {
    EXPECT_NEAR(normal_force(law, area, d), -(normal_energy(law, area, d + h) - normal_energy(law, area, d - h)) / (2 * h),
                1e-7 * std::max(1.0, normal_force(law, area, d)));
    EXPECT_NEAR(normal_stiffness(law, area, d), -(normal_force(law, area, d + h) - normal_force(law, area, d - h)) / (2 * h),
                1e-3);
  }
}

TEST(Contact, ComesCloserOnAReplicaButForTheClothsThickness) {
  Body body;
  Fabric thin, thick;
  thin.thickness = .15e-3;
  thick.thickness = .7e-3;
  body.form.height = .32;
  EXPECT_EQ(contact_law(thin, body).reach, ContactLaw{}.reach);  // a thing without bones
  body.form.bones.emplace_back();
  body.form.height = 1.75;
  EXPECT_EQ(contact_law(thin, body).reach, ContactLaw{}.reach);
  EXPECT_EQ(contact_law(thin, body).slip, ContactLaw{}.slip);
  body.form.height = .32;
  EXPECT_NEAR(contact_law(thin, body).reach, .2e-3, 1e-12);
  EXPECT_NEAR(contact_law(thin, body).slip, .04e-3, 1e-12);
  EXPECT_NEAR(contact_law(thick, body).reach, .35e-3, 1e-12);
  EXPECT_EQ(replica_reach(1.5e-3, 4e-3, body), 1.5e-3);  // cloth that is thicker than the reach is no nearer on any body
}

TEST(Friction, HoldsBelowTheConeAndNeverExceedsIt) {
  const ContactLaw law{.friction = .5};
  FrictionState state{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitY(), 2.0};
  const Eigen::Vector3d pull = friction_gradient(law, state, {1.0, .3, 0});
  EXPECT_NEAR(pull.norm(), 1, 1e-6);
  EXPECT_NEAR(pull.y(), 0, 1e-15);
  EXPECT_GT(friction_gradient(law, state, {1e-4, 0, 0}).norm(), .4);
}

TEST(Friction, HessianIsTheDifferenceQuotientOfTheGradient) {
  const ContactLaw law;
  FrictionState state{{.1, .2, .3}, Eigen::Vector3d(1, 2, .5).normalized(), 2.0};
  const Eigen::Vector3d x(.1003, .1999, .3002);
  const Eigen::Matrix3d hessian = friction_hessian(law, state, x);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d h = 1e-8 * Eigen::Vector3d::Unit(i);
    EXPECT_TRUE(
        hessian.col(i).isApprox((friction_gradient(law, state, x + h) - friction_gradient(law, state, x - h)) / 2e-8, 1e-5));
    const double quotient = (friction_energy(law, state, x + h) - friction_energy(law, state, x - h)) / 2e-8;
    EXPECT_NEAR(friction_gradient(law, state, x)(i), quotient, 1e-6);
  }
}

}  // namespace
}  // namespace toile::fem
