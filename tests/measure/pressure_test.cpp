#include "measure/pressure.h"

#include <gtest/gtest.h>

#include "drape/simulator.h"
#include "measure/maps.h"
#include "measure/worn_tube.h"

namespace toile {
namespace {

using test::round_body;
using test::tube_of_cloth;
using test::worn_round;

constexpr double radius = .12;

Fabric knit() {
  Fabric fabric;
  fabric.name = "knit";
  fabric.stretch_warp = 300, fabric.stretch_weft = 200, fabric.stretch_cross = 50, fabric.shear = 50;
  fabric.most_stretch = .4;
  fabric.bend_warp = fabric.bend_weft = 1e-7;
  return fabric;
}

// Hoop tension, N/m, of cloth whose weft is `hoop` times and whose warp `axial` times as long as at rest, over the width it has
// now: first Piola-Kirchhoff stress of the St. Venant-Kirchhoff law (the strains are tensile: nothing crumples, nothing locks).
double hoop_tension(const Fabric& fabric, double hoop, double axial) {
  const double weft = (hoop * hoop - 1) / 2, warp = (axial * axial - 1) / 2;
  return hoop * (fabric.stretch_weft * weft + fabric.stretch_cross * warp) / axial;
}

// Rows whose triangles and neighbours are all inside the tube.
std::vector<Eigen::Index> inner(const GarmentMesh& garment, int across) {
  std::vector<Eigen::Index> vertices;
  for (Eigen::Index v = 3 * across; v < garment.vertex_count - 3 * across; ++v) vertices.push_back(v);
  return vertices;
}

TEST(Pressure, OfATautTubeIsTensionOverRadius) {
  const Body body = round_body(radius);
  const Fabric fabric = knit();
  for (const double hoop : {1.02, 1.10, 1.25})
    for (const double axial : {1.0, 1.05}) {
      const GarmentMesh garment = tube_of_cloth((radius + 5e-4) / hoop, .3, 60, 24);
      const Eigen::VectorXd pressure = body_pressure(garment, worn_round(garment, radius + 5e-4, .6, axial), body, fabric);
      const double laplace = hoop_tension(fabric, hoop, axial) / (radius + 5e-4);
      double mean = 0;
      for (const Eigen::Index v : inner(garment, 60)) {
        ASSERT_NEAR(pressure(v), laplace, .01 * laplace) << hoop << ' ' << axial;
        mean += pressure(v) / static_cast<double>(inner(garment, 60).size());
      }
      EXPECT_NEAR(mean, laplace, .005 * laplace);
    }
}

// The same tube as the simulator leaves it, from a start that is off: its own contact has to carry just that pressure.
TEST(Pressure, OfATubeThatTheSimulatorDrapedIsTensionOverRadius) {
  const Body body = round_body(radius);
  Fabric fabric = knit();
  fabric.area_density = .02;
  fabric.stretch_cross = 0;  // else the tube gets shorter by as much as friction allows, and slacker
  const double hoop = 1.08;
  const GarmentMesh garment = tube_of_cloth(radius / hoop, .12, 60, 12);
  const Eigen::Matrix3Xd start = worn_round(garment, radius + 3e-3, .8);
  const Drape drape = find_simulator("fem").drape({garment, start, body, fabric, 1e-4});
  ASSERT_TRUE(drape.settled);
  const Eigen::VectorXd pressure = body_pressure(garment, drape.positions, body, fabric);
  double hangs = 0, mean = 0;
  const std::vector<Eigen::Index> vertices = inner(garment, 60);
  for (const Eigen::Index v : vertices) {
    hangs += drape.positions.col(v).cwiseProduct(Eigen::Vector3d(1, 0, 1)).norm() / static_cast<double>(vertices.size());
    mean += pressure(v) / static_cast<double>(vertices.size());
  }
  const double laplace = hoop_tension(fabric, hoop * hangs / radius, 1) / hangs;
  EXPECT_NEAR(mean, laplace, .01 * laplace);
  for (const Eigen::Index v : vertices) EXPECT_NEAR(pressure(v), laplace, .03 * laplace) << v;
}

TEST(Pressure, OfLooseClothIsNone) {
  const Body body = round_body(radius);
  const GarmentMesh loose = tube_of_cloth(radius + .02, .3, 60, 24);
  EXPECT_EQ(body_pressure(loose, worn_round(loose, radius + .02, .6), body, knit()).maxCoeff(), 0);
  // Taut, but not on the body: nothing there to press on.
  const GarmentMesh taut = tube_of_cloth(radius, .3, 60, 24);
  EXPECT_EQ(body_pressure(taut, worn_round(taut, radius + .02, .6), body, knit()).maxCoeff(), 0);
  // On the body, and slack: the weight hangs along the skin.
  const GarmentMesh slack = tube_of_cloth(radius + 1e-3, .3, 60, 24);
  EXPECT_LT(body_pressure(slack, worn_round(slack, radius + 1e-3, .6), body, knit()).maxCoeff(), 1);
  EXPECT_THROW(body_pressure(slack, Eigen::Matrix3Xd::Zero(3, 4), body, knit()), std::invalid_argument);
}

// Cloth flat on a level surface presses with its weight, each of two layers sewn on each other with its own.
TEST(Pressure, OfClothLyingFlatIsItsWeight) {
  const test::Closed top = test::box({0, .9, 0}, {.3, .1, .3});
  Mannequin form;
  form.name = "table", form.positions = top.positions, form.triangles = top.triangles;
  const Body table = test::body_of(form);
  GarmentMesh sheet = tube_of_cloth(.05, .3, 40, 20);
  const Eigen::Index n = sheet.panels[0].rest.cols();
  sheet.triangles = sheet.panels[0].triangles;
  sheet.vertex_count = static_cast<int>(n);
  sheet.welded[0] = Eigen::VectorXi::LinSpaced(n, 0, static_cast<int>(n) - 1);
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Constant(3, n, 1.0005);
  flat.row(0) = sheet.panels[0].rest.row(0).array() - .15;
  flat.row(2) = .15 - sheet.panels[0].rest.row(1).array();
  const Fabric fabric = knit();
  const double weight = 9.81 * fabric.area_density;  // Pa
  const Eigen::VectorXd single = body_pressure(sheet, flat, table, fabric);
  EXPECT_NEAR(single.minCoeff(), weight, 1e-6 * weight);
  EXPECT_NEAR(single.maxCoeff(), weight, 1e-6 * weight);
  sheet.panels[0].layers = Eigen::VectorXd::Constant(sheet.triangles.cols(), 2);
  EXPECT_NEAR(body_pressure(sheet, flat, table, fabric).minCoeff(), 2 * weight, 1e-6 * weight);
}

TEST(DrapeMaps, AreNamedAndOfTheRightNumber) {
  const Body body = round_body(radius);
  const GarmentMesh garment = tube_of_cloth(radius, .3, 60, 24);
  const std::vector<GarmentMap> maps = drape_maps(garment, worn_round(garment, radius + 1e-3, .6), body, knit());
  std::string names;
  for (const GarmentMap& map : maps) {
    names += map.name + ' ';
    EXPECT_EQ(map.values.size(), map.of == MapOf::triangle ? triangle_count(garment) : garment.vertex_count) << map.name;
    EXPECT_TRUE(map.values.allFinite()) << map.name;
    EXPECT_EQ(map.is_signed, map.name.rfind("stretch", 0) == 0);
  }
  EXPECT_EQ(names, "stretch_warp stretch_weft stretch_bias ease pressure ");
  EXPECT_NEAR(maps[1].values.mean() / maps[1].unit_size, 100 * 1e-3 / radius, 1e-6);  // %
  EXPECT_NEAR(maps[3].values.mean() / maps[3].unit_size, 1, .05);                     // mm
  EXPECT_GT(maps[4].values.mean() / maps[4].unit_size, 1e-3);                         // kPa
  EXPECT_LT(maps[4].values.mean() / maps[4].unit_size, 1);
}

}  // namespace
}  // namespace toile
