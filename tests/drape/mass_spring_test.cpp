#include "drape/mass_spring/mass_spring.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <utility>

#include "contracts/simulator_scenes.h"
#include "drape/mass_spring/body_contact.h"
#include "drape/mass_spring/relaxation.h"
#include "drape/simulator.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

using namespace mass_spring;

const Fabric orthotropic{.name = "orthotropic",
                         .area_density = .2,
                         .stretch_warp = 600,
                         .stretch_weft = 400,
                         .stretch_cross = 100,
                         .shear = 120,
                         .bend_warp = 2e-5,
                         .bend_weft = 1e-5,
                         .friction = .5};

TEST(SpringPull, IsTheDerivativeOfItsEnergyAndNeverFallsWithStrain) {
  const SpringLaw law{.limit = .1};
  constexpr double step = 1e-6;
  for (double strain = -.3; strain < .5; strain += .007) {
    const Pull here = pull_at(law, strain), more = pull_at(law, strain + step), less = pull_at(law, strain - step);
    EXPECT_NEAR((more.energy - less.energy) / (2 * step), here.pull, 1e-6) << strain;
    EXPECT_NEAR((more.pull - less.pull) / (2 * step), here.slope, 1e-3) << strain;
    EXPECT_GT(here.slope, 0) << strain;
  }
}

TEST(SpringNetwork, KeepsYoungsModuliWhateverCouplingSpringsCanHave) {
  for (const double shear : {5., 120., 400.}) {
    Fabric fabric = orthotropic;
    fabric.shear = shear;
    const NetworkStiffness c = network_stiffness(fabric);
    EXPECT_NEAR(c.warp - c.cross * c.cross / c.weft, 600 - 100. * 100 / 400, 1e-9);
    EXPECT_NEAR(c.weft - c.cross * c.cross / c.warp, 400 - 100. * 100 / 600, 1e-9);
    EXPECT_GE(c.cross, (100 + 2 * shear) / 3 - 1e-9);
  }
}

// A mesh stretched evenly: energy per area as of the sheet it stands for. Near-equilateral triangles have edges in three
// directions, too few for every orthotropic tensor: within 3 % where the fabric is as such a mesh can be, else within a sixth.
TEST(SpringNetwork, StretchedEvenlyHasTheEnergyOfTheFabricAlongWarpAndWeftAndOnTheBias) {
  Pattern pattern;
  pattern.pieces = {rectangle("sheet", .4, .3)};
  const double grain = .3;
  pattern.pieces[0].grainline = Grainline{{0, 0}, {std::sin(grain), std::cos(grain)}};
  const GarmentMesh sheet = sew(pattern, triangulate(pattern, {.edge_length = .02}));
  const Eigen::Vector2d warp = sheet.panels[0].warp, weft(-warp.y(), warp.x());
  ASSERT_NEAR(std::abs(warp.x()), std::sin(grain), 1e-9);
  Fabric even = orthotropic;
  even.stretch_weft = even.stretch_warp;
  even.stretch_cross = even.shear = even.stretch_warp / 3;
  for (const auto& [fabric, tolerance] : {std::pair(even, .03), std::pair(orthotropic, .17)}) {
    const NetworkStiffness c = network_stiffness(fabric);
    const std::vector<Spring> springs = edge_springs(sheet, fabric);
    const auto energy_per_area = [&](const Eigen::Matrix2d& strain) {  // of 1e-3 times that strain, over 1e-6
      const Eigen::Matrix2Xd x = (Eigen::Matrix2d::Identity() + 1e-3 * strain) * sheet.panels[0].rest;
      double sum = 0;
      for (const Spring& spring : springs) {
        const double stretch = (x.col(spring.b) - x.col(spring.a)).norm() - spring.rest;
        sum += spring.stiffness / 2 * stretch * stretch;
      }
      return sum / (.4 * .3) / 1e-6;
    };
    EXPECT_NEAR(energy_per_area(warp * warp.transpose()), c.warp / 2, tolerance * c.warp / 2);
    EXPECT_NEAR(energy_per_area(weft * weft.transpose()), c.weft / 2, tolerance * c.weft / 2);
    const Eigen::Matrix2d shear = (warp * weft.transpose() + weft * warp.transpose()) / 2;
    EXPECT_NEAR(energy_per_area(shear), c.cross / 2, tolerance * c.cross / 2);
  }
}

TEST(EdgeSprings, AGatheredSeamPullsToBothItsLengths) {
  const Pattern pattern = eased_seam(1.5);
  const GarmentMesh garment = sew(pattern, triangulate(pattern, {.edge_length = .03}));
  int pairs = 0;
  const std::vector<Spring> springs = edge_springs(garment, orthotropic);
  for (std::size_t i = 1; i < springs.size(); ++i)
    if (springs[i].a == springs[i - 1].a && springs[i].b == springs[i - 1].b) {
      const double ratio = springs[i].rest / springs[i - 1].rest;
      EXPECT_NEAR(std::max(ratio, 1 / ratio), 1.5, 1e-6);
      ++pairs;
    }
  EXPECT_GE(pairs, 10);
}

TEST(SpringStiffness, IsTheDerivativeOfItsForce) {
  const SpringLaw law{.limit = .1};
  const Spring spring{0, 1, .02, 30};
  std::srand(6);
  for (const double length : {.016, .0194, .02, .021, .024}) {
    Eigen::Matrix3Xd x(3, 2);
    x.col(0) = Eigen::Vector3d::Random();
    x.col(1) = x.col(0) + length * Eigen::Vector3d::Random().normalized();
    const double pull = pull_of(law, spring, x);
    const Eigen::Matrix3d stiffness = spring_stiffness(law, spring, x, pull);
    Eigen::Matrix3d differences;
    constexpr double step = 1e-7;
    for (int i = 0; i < 3; ++i) {
      Eigen::Matrix3Xd more = x, less = x;
      more(i, 0) += step;
      less(i, 0) -= step;
      differences.col(i) = (spring_force(law, spring, less) - spring_force(law, spring, more)) / (2 * step);
      EXPECT_NEAR((spring_energy(law, spring, less) - spring_energy(law, spring, more)) / (2 * step),
                  spring_force(law, spring, x)(i), 1e-6);
    }
    EXPECT_LT((differences - stiffness).norm(), 1e-4 * stiffness.norm()) << length;
    const Eigen::Matrix3d clamped = spring_stiffness(law, spring, x, std::max(pull, 0.));
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(clamped).eigenvalues()(0), -1e-9 * clamped.norm());
  }
}

class SpringsOnBall : public testing::Test {
 protected:
  const Body body_ = body_of(sphere({0, 1, 0}, .2, 4), "ball");
  const GarmentMesh sheet_ = crossed_sheet(.28, .28, 8);
  const Eigen::Matrix3Xd start_ = laid_on(sheet_, 0, .2005);
  const Cloth cloth_ = make_cloth(sheet_, orthotropic, body_);
};

TEST_F(SpringsOnBall, ForcesAreTheDerivativeOfTheEnergy) {
  std::srand(3);
  Eigen::Matrix3Xd x = start_;
  for (Eigen::Index v = 0; v < x.cols(); ++v) {  // bent onto the ball, and rumpled
    const Eigen::Vector3d out = (x.col(v) - Eigen::Vector3d(0, 1, 0)).normalized();
    x.col(v) = Eigen::Vector3d(0, 1, 0) + .2004 * out + .3e-3 * Eigen::Vector3d::Random();
  }
  Eigen::Matrix3Xd force;
  Eigen::VectorXd stiffness;
  BodyContact(cloth_).update(0, x, force, stiffness);
  ASSERT_GT(force.norm(), 0);
  add_inner_forces(cloth_, x, force);
  for (int i = 0; i < 10; ++i) {
    const Eigen::Matrix3Xd move = 1e-7 * Eigen::Matrix3Xd::Random(3, x.cols());
    const double work = force.cwiseProduct(move).sum();
    EXPECT_NEAR((energy(cloth_, x - move) - energy(cloth_, x + move)) / 2, work, 1e-3 * force.norm() * move.norm());
  }
}

TEST_F(SpringsOnBall, FollowingTheFieldIsAsGoodAsAskingIt) {
  std::srand(4);
  BodyContact following(cloth_);
  Eigen::Matrix3Xd x = start_, push, asked;
  Eigen::VectorXd stiffness;
  following.update(0, x, push, stiffness);
  for (int step = 0; step < 400; ++step) {
    Eigen::Matrix3Xd move = .02e-3 * Eigen::Matrix3Xd::Random(3, x.cols());
    move.row(1).array() -= .001e-3;
    x += move;
    following.update(move.colwise().norm().maxCoeff(), x, push, stiffness);
  }
  BodyContact(cloth_).update(0, x, asked, stiffness);
  ASSERT_GT(asked.norm(), 0);
  EXPECT_LT((push - asked).norm(), 1e-3 * asked.norm());
}

// At rest any small move costs more energy than friction could be owed.
TEST_F(SpringsOnBall, AtRestNoSmallMoveLowersTheEnergyByMoreThanFrictionHolds) {
  const Rest rest = relax(cloth_, start_, {.tolerance = 1e-6});
  ASSERT_TRUE(rest.settled) << rest.residual;
  Eigen::Matrix3Xd x = rest.x, push;
  Eigen::VectorXd stiffness;
  BodyContact(cloth_).update(0, x, push, stiffness);
  const double least = energy(cloth_, x);
  std::srand(5);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Matrix3Xd move = 1e-4 * Eigen::Matrix3Xd::Random(3, x.cols());
    const double held = orthotropic.friction * push.colwise().norm().dot(move.colwise().norm());
    EXPECT_GT(energy(cloth_, x + move) + held, least) << i;
  }
  const Rest again = relax(cloth_, rest.x, {.tolerance = 1e-6});
  EXPECT_LE(energy(cloth_, again.x), least + 1e-9);
}

TEST_F(SpringsOnBall, WhatNewtonMinimisesHasTheForcesOfTheRelaxation) {
  std::srand(7);
  const fem::Model model = make_model(sheet_, orthotropic, body_);
  const Eigen::Matrix3Xd x = start_ + .3e-3 * Eigen::Matrix3Xd::Random(3, start_.cols());
  Eigen::Matrix3Xd force;
  Eigen::VectorXd stiffness;
  Eigen::Matrix3Xd same = x;
  BodyContact(cloth_).update(0, same, force, stiffness);
  ASSERT_GT(force.norm(), 0);
  add_inner_forces(cloth_, x, force);
  EXPECT_EQ(same, x);
  EXPECT_LT((fem::gradient_without_friction(model, x) + force).norm(), 1e-9 * force.norm());
  const fem::Frozen loose{std::vector<fem::FrictionState>(static_cast<std::size_t>(x.cols())),
                          {},
                          std::vector<double>(model.hinges.size(), 0.),
                          {},
                          {}};
  EXPECT_NEAR(fem::energy(model, loose, x), energy(cloth_, x), 1e-9 * std::abs(energy(cloth_, x)));
}

// From the start, friction holds the two on different ways; from where one has come to rest the other has nowhere to go, but
// for the slip over which friction builds up anew.
TEST_F(SpringsOnBall, ComesToRestWhereTheRelaxationDoes) {
  const auto rest_of = [&](const char* name, const Eigen::Matrix3Xd& start) {
    const DrapeRequest request{.garment = sheet_, .start = start, .body = body_, .fabric = orthotropic, .tolerance = 1e-6};
    const Drape drape = find_simulator(name).drape(request);
    EXPECT_TRUE(drape.settled) << name;
    return drape.positions;
  };
  const auto apart = [](const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return (a - b).colwise().norm().mean(); };
  const Eigen::Matrix3Xd relaxed = rest_of("mass-spring-explicit", start_);
  EXPECT_LT(apart(rest_of("mass-spring", start_), relaxed), .01 * .28);
  EXPECT_LT(apart(rest_of("mass-spring", relaxed), relaxed), 2 * cloth_.contact.slip);
}

TEST_F(SpringsOnBall, DrapesAsFemDoesToAHundredthOfTheSheet) {
  const DrapeRequest request{.garment = sheet_, .start = start_, .body = body_, .fabric = orthotropic, .tolerance = 1e-4};
  const Drape springs = find_simulator("mass-spring").drape(request), fem = find_simulator("fem").drape(request);
  ASSERT_TRUE(springs.settled && fem.settled);
  EXPECT_LT((springs.positions - fem.positions).colwise().norm().mean(), .01 * .28);
}

}  // namespace
}  // namespace toile::test
