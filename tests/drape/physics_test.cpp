#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Dense>

#include "body/figure.h"
#include "drape/fem/assembly.h"
#include "drape/fem/model.h"
#include "drape/fem/newton.h"
#include "drape/simulator.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

const Fabric isotropic{.name = "isotropic",
                       .area_density = .2,
                       .stretch_warp = 600,
                       .stretch_weft = 600,
                       .stretch_cross = 150,
                       .shear = 225,
                       .bend_warp = 6e-5,
                       .bend_weft = 6e-5,
                       .friction = .6};

Body ball(double radius = .2) {
  Mannequin form;
  form.name = "ball";
  const Closed shape = sphere({0, 1, 0}, radius, 4);
  form.positions = shape.positions;
  form.triangles = shape.triangles;
  form.height = 1.7;
  return make_body(form);
}

// A square of cells with both diagonals, so that the mesh has the symmetry of the square.
GarmentMesh crossed_square(double side, int cells) {
  std::vector<Eigen::Vector2d> points;
  const double step = side / cells;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) points.emplace_back(i * step - side / 2, j * step - side / 2);
  PanelMesh panel;
  panel.name = "square";
  std::vector<Eigen::Vector3i> faces;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = c - 1, m = static_cast<int>(points.size());
      points.emplace_back((i + .5) * step - side / 2, (j + .5) * step - side / 2);
      for (const auto& face :
           {Eigen::Vector3i(a, b, m), Eigen::Vector3i(b, c, m), Eigen::Vector3i(c, d, m), Eigen::Vector3i(d, a, m)})
        faces.push_back(face);
    }
  panel.rest.resize(2, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) panel.rest.col(static_cast<Eigen::Index>(i)) = points[i];
  panel.triangles.resize(3, static_cast<Eigen::Index>(faces.size()));
  for (std::size_t i = 0; i < faces.size(); ++i) panel.triangles.col(static_cast<Eigen::Index>(i)) = faces[i];
  GarmentMesh garment;
  garment.vertex_count = static_cast<int>(points.size());
  garment.triangles = panel.triangles;
  garment.welded = {Eigen::VectorXi::LinSpaced(garment.vertex_count, 0, garment.vertex_count - 1)};
  garment.panels = {panel};
  return garment;
}

// Level, facing up, at `height`.
Eigen::Matrix3Xd level(const GarmentMesh& garment, double height) {
  Eigen::Matrix3Xd x(3, garment.vertex_count);
  x.row(0) = garment.panels[0].rest.row(0);
  x.row(1).setConstant(height);
  x.row(2) = -garment.panels[0].rest.row(1);
  return x;
}

class SheetOnBall : public testing::Test {
 protected:
  const Body body_ = ball();
  const GarmentMesh sheet_ = crossed_square(.36, 12);
  const Eigen::Matrix3Xd start_ = level(sheet_, 1.2005);
  // Too small to hang in folds, so that there is one equilibrium near by.
  const GarmentMesh cap_ = crossed_square(.2, 8);
  const Eigen::Matrix3Xd cap_start_ = level(cap_, 1.2005);
  Drape drape(const char* simulator, double tolerance) const {
    return find_simulator(simulator).drape(
        {.garment = sheet_, .start = start_, .body = body_, .fabric = isotropic, .tolerance = tolerance});
  }
};

TEST_F(SheetOnBall, SettlesOutsideTheBodyAndAsSymmetricAsItIs) {
  const Drape drape = this->drape("fem", 1e-5);
  EXPECT_TRUE(drape.settled) << drape.residual;
  EXPECT_LE(drape.residual, 1e-5);
  EXPECT_LT(drape.max_penetration, .5e-3);
  EXPECT_EQ(drape.inverted_triangles, 0);
  // It hangs over the ball, and the vertices that mirror into each other about x = 0 do so to 1 % of the side.
  EXPECT_LT(drape.positions.row(1).minCoeff(), 1.15);
  double worst = 0;
  const auto& rest = sheet_.panels[0].rest;
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    const Eigen::Vector2d mirrored(-rest(0, v), rest(1, v));
    Eigen::Index other = 0;
    (rest.colwise() - mirrored).colwise().squaredNorm().minCoeff(&other);
    worst =
        std::max(worst, (drape.positions.col(other) - Eigen::Vector3d(-1, 1, 1).cwiseProduct(drape.positions.col(v))).norm());
  }
  EXPECT_LT(worst, .01 * .36);
  RecordProperty("asymmetry_mm", std::to_string(1e3 * worst));
}

TEST_F(SheetOnBall, TheSameTwiceToTheBit) {
  const Drape once = drape("fem", 1e-4), again = drape("fem", 1e-4);
  EXPECT_EQ(once.steps, again.steps);
  EXPECT_TRUE((once.positions.array() == again.positions.array()).all());
}

TEST_F(SheetOnBall, TheSameToTheBitWithOneThreadAndWithTwo) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Drape one = drape("fem", 1e-3);
  omp_set_num_threads(2);
  const Drape two = drape("fem", 1e-3);
  omp_set_num_threads(threads);
  EXPECT_EQ(one.steps, two.steps);
  EXPECT_TRUE((one.positions.array() == two.positions.array()).all());
}

// Near: from a drape at rest, with the pattern one percent smaller, as every step of the adjustment asks. (From far away either
// may find other folds.)
TEST_F(SheetOnBall, BothSolversFindTheSameDrape) {
  const DrapeRequest far{.garment = cap_, .start = cap_start_, .body = body_, .fabric = isotropic, .tolerance = 1e-4};
  const Eigen::Matrix3Xd start = find_simulator("fem").drape(far).positions;
  RestShape smaller = rest_shape(cap_);
  for (Eigen::Matrix2Xd& panel : smaller) panel *= .99;
  const GarmentMesh changed = with_rest(cap_, smaller);
  const DrapeRequest near{.garment = changed, .start = start, .body = body_, .fabric = isotropic, .tolerance = 1e-4};
  const Drape full = find_simulator("fem").drape(near), projected = find_simulator("fem-projected").drape(near);
  EXPECT_TRUE(full.settled && projected.settled);
  EXPECT_GT((full.positions - start).colwise().norm().maxCoeff(), .5e-3);
  EXPECT_LT((full.positions - projected.positions).colwise().norm().maxCoeff(), .5e-3);
}

TEST_F(SheetOnBall, NoSmallMoveAwayFromEquilibriumLowersTheEnergy) {
  const fem::Model model = fem::make_model(cap_, isotropic, body_);
  const fem::Equilibrium found = fem::find_equilibrium(model, cap_start_, {.tolerance = 2e-5});
  ASSERT_TRUE(found.settled) << found.residual;
  fem::Frozen friction = fem::frozen_at(model, cap_start_);
  for (int i = 0; i < 60; ++i) fem::update_friction(model, found.x, 1, friction);
  const double least = fem::energy(model, friction, found.x);
  std::srand(5);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3Xd move = 1e-4 * Eigen::Matrix3Xd::Random(3, found.x.cols());
    EXPECT_GT(fem::energy(model, friction, found.x + move), least) << i;
  }
}

// Between three corners that touch a round body the middle of the triangle would sag into it: by more than the edges do.
TEST(CoarseCloth, DoesNotSinkIntoARoundBodyBetweenItsVertices) {
  const Body body = ball(.1);
  const GarmentMesh sheet = crossed_square(.12, 3);
  Fabric heavy = isotropic;
  heavy.area_density = 1;
  const Eigen::Matrix3Xd start = level(sheet, 1.1005);
  const Drape drape =
      find_simulator("fem").drape({.garment = sheet, .start = start, .body = body, .fabric = heavy, .tolerance = 1e-4});
  EXPECT_TRUE(drape.settled) << drape.residual;
  EXPECT_LT(drape.positions.row(1).minCoeff(), 1.09);
  EXPECT_LT(drape.max_penetration, .1e-3);
}

TEST(WeightlessCloth, FarFromTheBodyStaysWhereItIs) {
  const Body body = ball();
  const GarmentMesh sheet = crossed_square(.2, 4);
  fem::Model model = fem::make_model(sheet, isotropic, body);
  model.weight_direction.setZero();
  const Eigen::Matrix3Xd start = level(sheet, 2);
  const Eigen::Matrix3Xd force = fem::gradient_without_friction(model, start);
  EXPECT_LT(force.norm(), 1e-12 * isotropic.stretch_warp);
}

// Force per width at the top of a strip that hangs by it: its weight, rho g L; the law gives the stretch there. The elongation
// of the whole is the integral, rho g L^2 / (2 Y) with Y = C11 - C12^2 / C22 for a strip free to narrow (C11 without coupling).
TEST(HangingStrip, GetsLongerByItsOwnWeightAsTheClosedFormSays) {
  Fabric fabric = isotropic;
  fabric.stretch_cross = 0;
  const double length = .3;
  const Body body = ball();
  const GarmentMesh strip = crossed_square(length, 20);
  fem::Model model = fem::make_model(strip, fabric, body);
  Eigen::Matrix3Xd x(3, strip.vertex_count);
  x.topRows<2>() = strip.panels[0].rest;
  x.row(1).array() += 3;
  x.row(2).setZero();
  // Newton's method on the model's own energy with the top row held.
  const fem::Frozen nothing = fem::frozen_at(model, x);
  const auto assembly = fem::make_assembly(model);
  std::vector<int> held;
  for (int v = 0; v < strip.vertex_count; ++v)
    if (strip.panels[0].rest(1, v) > length / 2 - 1e-9) held.push_back(v);
  ASSERT_EQ(held.size(), 21u);
  for (int step = 0; step < 8; ++step) {
    Eigen::Matrix3Xd force = fem::gradient_without_friction(model, x);
    fem::assemble(model, nothing, x, fem::Curvature::clamped, *assembly);
    for (const int v : held) {
      force.col(v).setZero();
      assembly->matrix.add_diagonal(v, 1e9);
    }
    for (int v = 0; v < strip.vertex_count; ++v) assembly->matrix.add_diagonal(v, 1e-6);  // out of its plane it is limp
    ASSERT_TRUE(assembly->matrix.factorise());
    x -= assembly->matrix.solve(force);
  }
  double bottom = 0;
  int count = 0;
  for (int v = 0; v < strip.vertex_count; ++v)
    if (strip.panels[0].rest(1, v) < -length / 2 + 1e-9) bottom += 3 - length / 2 - x(1, v), ++count;
  const double expected = fabric.area_density * fem::gravity * length * length / (2 * fabric.stretch_warp);
  EXPECT_NEAR(bottom / count, expected, .01 * expected);
}

}  // namespace
}  // namespace toile::test
