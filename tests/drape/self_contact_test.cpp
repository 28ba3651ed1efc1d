#include "drape/fem/self_contact.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "body/figure.h"
#include "collide/intersections.h"
#include "drape/simulator.h"

namespace toile::test {
namespace {

TEST(Barrier, SlopeAndCurvatureAreItsDerivatives) {
  const fem::SelfContactLaw law;
  for (const double u : {.05, .3, .7, .99}) {
    const double d = u * law.reach, h = 1e-6 * law.reach;
    const double slope = (fem::barrier(law, d + h) - fem::barrier(law, d - h)) / (2 * h);
    EXPECT_NEAR(fem::barrier_slope(law, d), slope, 1e-5 * std::abs(slope) + 1e-6) << u;
    const double curvature = (fem::barrier_slope(law, d + h) - fem::barrier_slope(law, d - h)) / (2 * h);
    EXPECT_NEAR(fem::barrier_curvature(law, d), curvature, 1e-5 * std::abs(curvature)) << u;
  }
}

TEST(Barrier, EndsAtItsReachAndIsInfiniteAtTouch) {
  const fem::SelfContactLaw law;
  EXPECT_EQ(fem::barrier(law, law.reach), 0);
  EXPECT_EQ(fem::barrier_slope(law, law.reach), 0);
  EXPECT_EQ(fem::barrier_curvature(law, law.reach), 0);
  EXPECT_TRUE(std::isinf(fem::barrier(law, 0)));
}

// A vertex .6 mm above a triangle, and an edge .9 mm across another.
struct Met {
  Eigen::Matrix3Xd x;
  fem::SelfContact contact;
};

Met met() {
  Met m;
  m.x.resize(3, 8);
  m.x << .003, 0, .01, 0, 0, .01, .005, .006,  //
      .0006, 0, .0001, 0, 0, 0, .0009, .001,   //
      .003, 0, 0, .01, 0, 0, -.004, .005;
  NearPair corner;
  corner.vertex = {0, 1, 2, 3};
  corner.first = 1;
  corner.weight << 1, .4, .3, .3;
  corner.normal = Eigen::Vector3d(.01, 1, -.02).normalized();
  NearPair crossing;
  crossing.vertex = {6, 7, 4, 5};
  crossing.first = 2;
  crossing.weight << .5, .5, .4, .6;
  crossing.normal = Eigen::Vector3d(0, 1, .1).normalized();
  m.contact.pairs = {corner, crossing};
  m.contact.area = {2e-5, 3e-5};
  return m;
}

TEST(SelfContact, GradientIsTheDifferenceQuotientOfTheEnergy) {
  const Met m = met();
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, 8);
  add_self_contact(m.contact, m.x, gradient);
  EXPECT_GT(gradient.norm(), 1e-3);
  EXPECT_LT(gradient.rowwise().sum().norm(), 1e-12);  // it pushes both sides alike
  for (Eigen::Index i = 0; i < m.x.size(); ++i) {
    Eigen::Matrix3Xd above = m.x, below = m.x;
    above.data()[i] += 1e-9;
    below.data()[i] -= 1e-9;
    EXPECT_NEAR(gradient.data()[i], (self_contact_energy(m.contact, above) - self_contact_energy(m.contact, below)) / 2e-9,
                1e-5);
  }
}

TEST(SelfContact, HessianIsTheDifferenceQuotientOfTheGradient) {
  const Met m = met();
  BlockMatrix hessian(8, coupled_vertices(m.contact));
  add_self_contact(m.contact, m.x, hessian);
  for (Eigen::Index i = 0; i < m.x.size(); ++i) {
    Eigen::Matrix3Xd unit = Eigen::Matrix3Xd::Zero(3, 8), above = Eigen::Matrix3Xd::Zero(3, 8), below = above;
    unit.data()[i] = 1;
    add_self_contact(m.contact, m.x + 1e-9 * unit, above);
    add_self_contact(m.contact, m.x - 1e-9 * unit, below);
    const Eigen::Matrix3Xd quotient = (above - below) / 2e-9;
    EXPECT_LT((hessian.multiply(unit) - quotient).norm(), 1e-4 * (1 + quotient.norm())) << i;
  }
}

GarmentMesh square(double side, int cells) {
  PanelMesh panel;
  panel.name = "square";
  const int row = cells + 1;
  panel.rest.resize(2, row * row);
  for (int j = 0; j < row; ++j)
    for (int i = 0; i < row; ++i) panel.rest.col(j * row + i) << side * i / cells - side / 2, side * j / cells - side / 2;
  panel.triangles.resize(3, 2 * cells * cells);
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * row + i, t = 2 * (j * cells + i);
      panel.triangles.col(t) << a, a + 1, a + row;
      panel.triangles.col(t + 1) << a + 1, a + row + 1, a + row;
    }
  GarmentMesh garment;
  garment.panels = {panel, panel};
  garment.panels[1].name = "upper";
  const int n = row * row;
  garment.vertex_count = 2 * n;
  garment.welded = {Eigen::VectorXi::LinSpaced(n, 0, n - 1), Eigen::VectorXi::LinSpaced(n, n, 2 * n - 1)};
  garment.triangles.resize(3, 2 * panel.triangles.cols());
  garment.triangles << panel.triangles, panel.triangles.array() + n;
  return garment;
}

// Two sheets on a ball: without contact the upper one would come to lie in the lower one.
TEST(SelfContact, KeepsASheetOnTopOfAnother) {
  Mannequin form;
  form.name = "ball";
  const Closed shape = sphere({0, 1, 0}, .2, 4);
  form.positions = shape.positions;
  form.triangles = shape.triangles;
  form.height = 1.7;
  const Body body = make_body(form);
  const GarmentMesh garment = square(.25, 10);
  const int n = garment.vertex_count / 2;
  Eigen::Matrix3Xd start(3, 2 * n);
  for (int v = 0; v < 2 * n; ++v) {
    const Eigen::Vector2d at = garment.panels[0].rest.col(v % n);
    start.col(v) << at.x() + (v < n ? 0 : .004), v < n ? 1.2005 : 1.2045, -at.y();
  }
  const Fabric fabric{.name = "plain",
                      .area_density = .2,
                      .stretch_warp = 600,
                      .stretch_weft = 600,
                      .stretch_cross = 150,
                      .shear = 225,
                      .bend_warp = 2e-5,
                      .bend_weft = 2e-5,
                      .friction = .6};
  for (const char* name : {"fem", "fem-projected"}) {
    const Drape drape =
        find_simulator(name).drape({.garment = garment, .start = start, .body = body, .fabric = fabric, .tolerance = 1e-3});
    // Projected Newton creeps where layers slide on each other; what it leaves must be as sound.
    EXPECT_TRUE(drape.settled || name != std::string("fem")) << name << " " << drape.residual;
    EXPECT_TRUE(intersecting_triangles(drape.positions, garment.triangles).empty()) << name;
    EXPECT_EQ(drape.self_intersections, 0);
    const Eigen::Matrix3Xd &x = drape.positions, lower = x.leftCols(n), upper = x.rightCols(n);
    EXPECT_LT(upper.row(1).minCoeff(), 1.19) << "it hangs over the ball";
    const double lower_top = (lower.colwise() - Eigen::Vector3d(0, 1, 0)).colwise().norm().mean();
    const double upper_top = (upper.colwise() - Eigen::Vector3d(0, 1, 0)).colwise().norm().mean();
    EXPECT_GT(upper_top, lower_top + .3e-3) << name;
  }
}

}  // namespace
}  // namespace toile::test
