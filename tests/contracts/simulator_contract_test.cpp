// What every simulator promises. Being in simulators() is being tested here; so is another program, behind files.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <ostream>
#include <stdexcept>

#include "contracts/simulator_scenes.h"
#include "drape/simulator.h"

namespace toile {

void PrintTo(const Simulator& simulator, std::ostream* out) { *out << simulator.name; }

namespace test {
namespace {

constexpr double gravity = 9.81;  // m/s^2

const Fabric cloth{.name = "cloth",
                   .area_density = .2,
                   .stretch_warp = 600,
                   .stretch_weft = 600,
                   .stretch_cross = 150,
                   .shear = 225,
                   .bend_warp = 2e-5,
                   .bend_weft = 2e-5,
                   .friction = .5};

class SimulatorContract : public testing::TestWithParam<Simulator> {};

double mean_height(const Eigen::Matrix3Xd& x) { return x.row(1).mean(); }

double longest_move(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return (a - b).colwise().norm().maxCoeff(); }

TEST_P(SimulatorContract, DescribesItself) {
  EXPECT_FALSE(GetParam().name.empty());
  EXPECT_FALSE(GetParam().summary.empty());
  EXPECT_EQ(find_simulator(GetParam().name).name, GetParam().name);
}

TEST_P(SimulatorContract, ASheetOnATableStaysWhereItIs) {
  const Body body = table();
  const GarmentMesh sheet = crossed_sheet(.2, .2, 6);
  const Eigen::Matrix3Xd start = laid_on(sheet, 0, .95e-3);
  const Drape drape = GetParam().drape({.garment = sheet, .start = start, .body = body, .fabric = cloth, .tolerance = 1e-4});
  EXPECT_TRUE(drape.settled) << drape.residual;
  EXPECT_LE(drape.residual, 1e-4);
  EXPECT_EQ(drape.simulator, GetParam().name);
  EXPECT_EQ(drape.max_penetration, 0);
  EXPECT_LT(longest_move(drape.positions, start), .2e-3);
}

// "Slides exactly beyond the angle": Coulomb, tan(angle) against the coefficient, three percent to either side.
TEST_P(SimulatorContract, ASheetOnASlopeHoldsBelowTheAngleOfFrictionAndSlidesBeyond) {
  const GarmentMesh sheet = crossed_sheet(.15, .15, 4);
  for (const double share : {.97, 1.03}) {
    const double angle = std::atan(share * cloth.friction);
    const Body body = table(angle);
    const Eigen::Matrix3Xd start = laid_on(sheet, angle, .95e-3);
    const Drape drape = GetParam().drape({.garment = sheet, .start = start, .body = body, .fabric = cloth, .tolerance = 1e-3});
    const double slid = slope_frame(angle).col(1).dot((drape.positions - start).rowwise().mean());
    if (share < 1) {
      EXPECT_TRUE(drape.settled) << drape.residual;
      EXPECT_LT(slid, 1.5e-3);
    } else {
      // Until it falls off the table, on whose edge it may come to rest again.
      EXPECT_TRUE(!drape.settled || slid > 20e-3) << "slid " << slid;
    }
  }
}

// The ends of a strip hung over a rod. At q above the free end it carries rho g q per width, so that between q1 and q2 it gets
// longer by rho g (q2^2 - q1^2) / (2 Y); Young's modulus Y, because it is free to get narrower.
TEST_P(SimulatorContract, AHangingStripGetsLongerAsTheClosedFormSays) {
  Fabric fabric = cloth;
  fabric.stretch_warp = 120;
  fabric.stretch_weft = 90;
  fabric.stretch_cross = 20;
  fabric.shear = 30;
  const double length = .6, young = 120 - 20. * 20 / 90;
  const Body body = bar();
  GarmentMesh strip = crossed_sheet(.06, length, 4);
  const Eigen::Matrix2Xd& rest = strip.panels[0].rest;
  for (const bool hemmed : {false, true}) {
    // Hemmed: twice the cloth, twice the weight, within 6 cm of the ends.
    const double hem = hemmed ? .06 : 0;
    if (hemmed) {
      strip.panels[0].layers = Eigen::VectorXd::Ones(strip.triangles.cols());
      for (Eigen::Index t = 0; t < strip.triangles.cols(); ++t) {
        double middle = 0;
        for (int i = 0; i < 3; ++i) middle += rest(1, strip.triangles(i, t)) / 3;
        if (length / 2 - std::abs(middle) < hem) strip.panels[0].layers(t) = 2;
      }
    }
    const Drape drape =
        GetParam().drape({.garment = strip, .start = hung_over_bar(strip), .body = body, .fabric = fabric, .tolerance = 1e-4});
    EXPECT_TRUE(drape.settled) << drape.residual;
    const auto height = [&](double q) {  // mean height of the row of vertices q above the end at rest y = -length / 2
      double sum = 0;
      int count = 0;
      for (Eigen::Index v = 0; v < rest.cols(); ++v)
        if (std::abs(rest(1, v) - (q - length / 2)) < 1e-9) sum += drape.positions(1, v), ++count;
      return sum / count;
    };
    const double low = .06, high = .21;
    const double expected = fabric.area_density * gravity / young * ((high * high - low * low) / 2 + hem * (high - low));
    EXPECT_NEAR(height(high) - height(low) - (high - low), expected, .05 * expected) << (hemmed ? "hemmed" : "plain");
  }
}

class OnBall : public SimulatorContract {
 protected:
  const Body body_ = body_of(sphere({0, 1, 0}, .2, 4), "ball");
  const GarmentMesh sheet_ = crossed_sheet(.28, .28, 8);
  const Eigen::Matrix3Xd start_ = laid_on(sheet_, 0, .2005);
  DrapeRequest request(const Eigen::Matrix3Xd& start) const {
    return {.garment = sheet_, .start = start, .body = body_, .fabric = cloth, .tolerance = 1e-4};
  }
};

TEST_P(OnBall, HangsOutsideTheBallAndAsSymmetricAsTheSheet) {
  const Drape drape = GetParam().drape(request(start_));
  EXPECT_TRUE(drape.settled) << drape.residual;
  EXPECT_LT(drape.max_penetration, .5e-3);
  EXPECT_EQ(drape.inverted_triangles, 0);
  EXPECT_LT(drape.positions.row(1).minCoeff(), 1.16);
  const Eigen::Matrix2Xd& rest = sheet_.panels[0].rest;
  for (Eigen::Index v = 0; v < rest.cols(); ++v) {
    Eigen::Index other = 0;
    (rest.colwise() - Eigen::Vector2d(-rest(0, v), rest(1, v))).colwise().squaredNorm().minCoeff(&other);
    const Eigen::Vector3d mirrored = Eigen::Vector3d(-1, 1, 1).cwiseProduct(drape.positions.col(v));
    EXPECT_LT((drape.positions.col(other) - mirrored).norm(), .01 * .28) << v;
  }
}

TEST_P(OnBall, GivesTheSameBytesTwice) {
  const Drape once = GetParam().drape(request(start_)), again = GetParam().drape(request(start_));
  EXPECT_EQ(once.positions, again.positions);
  EXPECT_EQ(once.residual, again.residual);
  EXPECT_EQ(once.steps, again.steps);
}

TEST_P(OnBall, FromItsOwnDrapeItNeitherMovesNorRises) {
  const Drape drape = GetParam().drape(request(start_));
  const Drape again = GetParam().drape(request(drape.positions));
  EXPECT_TRUE(again.settled);
  EXPECT_LT(longest_move(again.positions, drape.positions), 2e-3);
  EXPECT_LT(mean_height(again.positions), mean_height(drape.positions) + .05e-3);  // friction starts afresh
  EXPECT_LT(mean_height(drape.positions), mean_height(start_));
}

TEST_P(OnBall, TellsHowFarItIsAndStopsWhenItsTimeIsUp) {
  DrapeRequest asked = request(start_);
  int told = 0;
  asked.progress = [&](const DrapeProgress& progress) {
    ++told;
    EXPECT_EQ(progress.tolerance, 1e-4);
    EXPECT_GE(progress.residual, 0);
  };
  EXPECT_TRUE(GetParam().drape(asked).settled);
  EXPECT_GT(told, 0);
  asked.time_limit = 0;
  const Drape stopped = GetParam().drape(asked);
  EXPECT_FALSE(stopped.settled);
  EXPECT_TRUE(stopped.positions.allFinite());
}

TEST_P(OnBall, RefusesAStartThatIsNotThisGarments) {
  const Eigen::Matrix3Xd fewer = start_.leftCols(5);
  EXPECT_THROW(GetParam().drape(request(fewer)), std::invalid_argument);
  Eigen::Matrix3Xd broken = start_;
  broken(1, 3) = std::nan("");
  EXPECT_THROW(GetParam().drape(request(broken)), std::invalid_argument);
}

const auto by_name = [](const auto& simulator) {
  std::string name = simulator.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
};
INSTANTIATE_TEST_SUITE_P(All, SimulatorContract, testing::ValuesIn(simulators()), by_name);
INSTANTIATE_TEST_SUITE_P(All, OnBall, testing::ValuesIn(simulators()), by_name);

const auto external = [](const auto&) { return std::string("external"); };
INSTANTIATE_TEST_SUITE_P(StandIn, SimulatorContract, testing::Values(find_simulator(TOILE_STAND_IN)), external);
INSTANTIATE_TEST_SUITE_P(StandIn, OnBall, testing::Values(find_simulator(TOILE_STAND_IN)), external);

}  // namespace
}  // namespace test
}  // namespace toile
