#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Dense>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "body/figure.h"
#include "contracts/simulator_scenes.h"
#include "drape/simulator.h"
#include "formats/formats.h"
#include "held_cloth.h"
#include "triangulate/sample_patterns.h"
#include "triangulate/triangulate.h"

namespace toile::test {
namespace {

constexpr double pi = std::numbers::pi;

Body nobody() { return body_of(sphere({0, -10, 0}, .2, 2), "far away"); }

std::vector<std::filesystem::path> fabrics() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics"))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// Angle below the level of the straight line from edge to tip of a heavy inextensible strip clamped level: the elastica
// theta'' = -load (1 - s) cos(theta), theta(0) = 0, theta'(1) = 0 by shooting; load = weight gravity length^3 / B.
double droop_of_elastica(double load) {
  const int parts = 400;
  const double h = 1. / parts;
  struct End {
    double slope, angle;
  };
  const auto shoot = [&](double slope) -> End {
    double theta = 0, reach = 0, drop = 0;
    const auto pull = [&](double s, double t) { return -load * (1 - s) * std::cos(t); };
    for (int i = 0; i < parts; ++i) {
      const double s = i * h, a = slope, b = pull(s, theta);
      const double a2 = slope + h / 2 * b, b2 = pull(s + h / 2, theta + h / 2 * a);
      const double a3 = slope + h / 2 * b2, b3 = pull(s + h / 2, theta + h / 2 * a2);
      const double a4 = slope + h * b3, b4 = pull(s + h, theta + h * a3);
      const double next = theta + h / 6 * (a + 2 * a2 + 2 * a3 + a4);
      reach += h * std::cos((theta + next) / 2);
      drop += h * std::sin((theta + next) / 2);
      slope += h / 6 * (b + 2 * b2 + 2 * b3 + b4);
      theta = next;
    }
    return {slope, std::atan2(drop, reach)};
  };
  double low = 0, high = load;
  for (int i = 0; i < 60; ++i) (shoot((low + high) / 2).slope > 0 ? high : low) = (low + high) / 2;
  return shoot(low).angle;
}

// The bending length that an overhang drooping to `angle` means.
double bending_length(double overhang, double angle) {
  double low = .01, high = 100;
  for (int i = 0; i < 60; ++i) (droop_of_elastica((low + high) / 2) > angle ? high : low) = (low + high) / 2;
  return overhang / std::cbrt(low);
}

// A strip along +y of its panels' plane in the kind of mesh that garments have, sewn at y = 0 to the part that is clamped.
struct Strip {
  GarmentMesh mesh;
  Eigen::Matrix2Xd rest;  // by garment vertex
};

Strip clamped_strip(double width, double overhang, double clamped, int cells, const Eigen::Vector2d& warp) {
  Pattern pattern;
  pattern.pieces = {rectangle("held", width, clamped, {0, -clamped}), rectangle("free", width, overhang)};
  pattern.seams = {{"edge", span("held", 1, "top"), span("free", 1, "bottom", 1, 0), false}};
  Strip strip{sew(pattern, triangulate(pattern, {.edge_length = overhang / cells})), {}};
  strip.rest.resize(2, strip.mesh.vertex_count);
  for (std::size_t p = 0; p < 2; ++p) {
    strip.mesh.panels[p].warp = warp;
    for (Eigen::Index v = 0; v < strip.mesh.panels[p].rest.cols(); ++v)
      strip.rest.col(strip.mesh.welded[p](v)) = strip.mesh.panels[p].rest.col(v);
  }
  return strip;
}

// Droop of an overhang, clamped level.
double droop(const Fabric& cloth, bool along_warp, double overhang, int cells) {
  const Strip strip = clamped_strip(overhang / 4, overhang, overhang / 6, cells,
                                    along_warp ? Eigen::Vector2d::UnitY() : Eigen::Vector2d::UnitX());
  const Body body = nobody();
  const fem::Model model = fem::make_model(strip.mesh, cloth, body);
  Eigen::Matrix3Xd start(3, strip.mesh.vertex_count);
  std::vector<int> held;
  for (int v = 0; v < strip.mesh.vertex_count; ++v) {
    start.col(v) << strip.rest(0, v), 0, strip.rest(1, v);
    if (strip.rest(1, v) < 1e-9) held.push_back(v);
  }
  const HeldCloth found = settle_held(model, start, held);
  EXPECT_LT(found.residual, 1e-6) << cloth.name;
  double drop = 0, reach = 0;
  int tips = 0;
  for (int v = 0; v < strip.mesh.vertex_count; ++v)
    if (strip.rest(1, v) > overhang - 1e-9) drop -= found.x(1, v), reach += found.x(2, v), ++tips;
  EXPECT_GE(tips, 3);
  return std::atan2(drop, reach);
}

class Cantilever : public testing::TestWithParam<std::filesystem::path> {};

// Peirce 1930, BS 3356, ASTM D1388: an overhang of twice the bending length droops to 41.5 degrees.
TEST_P(Cantilever, OfTwiceTheBendingLengthDroopsTo41DegreesAndAHalf) {
  Fabric cloth = *read_fabric(GetParam()).value;
  cloth.bend_friction = 0;
  for (const bool warp : {true, false}) {
    const double length = std::cbrt((warp ? cloth.bend_warp : cloth.bend_weft) / (cloth.area_density * fem::gravity));
    const double angle = droop(cloth, warp, 2 * length, 24);
    const double shown = bending_length(2 * length, angle);
    std::cout << GetParam().stem().string() << (warp ? " warp " : " weft ") << 180 / pi * angle << " deg, bending length "
              << 100 * shown << " cm for " << 100 * length << " (" << 100 * (shown / length - 1) << " %)\n";
    EXPECT_NEAR(shown, length, .05 * length);
    RecordProperty(warp ? "warp_error_percent" : "weft_error_percent", std::to_string(100 * (shown / length - 1)));
  }
}

INSTANTIATE_TEST_SUITE_P(All, Cantilever, testing::ValuesIn(fabrics()),
                         [](const auto& file) { return file.param.stem().string(); });

TEST(Elastica, DroopsTo41DegreesAndAHalfAtTwiceTheBendingLength) {
  EXPECT_NEAR(180 / pi * droop_of_elastica(8), 41.5, .05);
  // A short stiff strip is a beam: drop / reach = load / 8.
  EXPECT_NEAR(droop_of_elastica(.01), .01 / 8, 1e-6);
}

// Square cells, warp along y, `turn` radians anticlockwise from it.
GarmentMesh cloth_square(double side, int cells, double turn = 0) {
  GarmentMesh square = crossed_sheet(side, side, cells);
  square.panels[0].warp = Eigen::Vector2d(-std::sin(turn), std::cos(turn));
  return square;
}

std::vector<int> outline(const GarmentMesh& square, double side) {
  std::vector<int> on;
  for (int v = 0; v < square.vertex_count; ++v)
    if (square.panels[0].rest.col(v).cwiseAbs().maxCoeff() > side / 2 - 1e-9) on.push_back(v);
  return on;
}

// Rods of length a hinged at the corners keep the threads' lengths: the Green strain is sin(angle) / 2 of pure shear, the
// energy G a^2 sin^2(angle) / 2, and pulling two opposite corners apart takes its derivative over that of their distance, 2 a
// cos(pi/4 - angle/2): P = G a sin(angle) cos(angle) / sin(pi/4 - angle/2).
TEST(PictureFrame, IsPulledWithTheForceOfTheClosedForm) {
  const Fabric cloth = *read_fabric(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics/cotton_poplin.toml").value;
  const double side = .1;
  const GarmentMesh square = cloth_square(side, 6);
  const Body body = nobody();
  fem::Model model = fem::make_model(square, cloth, body);
  model.weight_direction.setZero();
  for (const double degrees : {2., 8., 20.}) {
    const double angle = degrees * pi / 180;
    Eigen::Matrix<double, 3, 2> frame, change;  // of the threads' directions, and by the angle
    frame << std::sin(angle / 2), std::cos(angle / 2), std::cos(angle / 2), std::sin(angle / 2), 0, 0;
    frame.col(0).swap(frame.col(1));
    change << -std::sin(angle / 2), std::cos(angle / 2), std::cos(angle / 2), -std::sin(angle / 2), 0, 0;
    change /= 2;
    // The inside starts disturbed and has to find its place.
    Eigen::Matrix3Xd start = frame * square.panels[0].rest;
    const std::vector<int> held = outline(square, side);
    for (int v = 0; v < square.vertex_count; ++v)
      if (std::find(held.begin(), held.end(), v) == held.end()) start(0, v) += 1e-3 * std::sin(7. * v);
    const HeldCloth found = settle_held(model, start, held, 1e-10);
    double work = 0;  // of the frame, per radian
    for (const int v : held) work += found.reaction.col(v).dot(change * square.panels[0].rest.col(v));
    const double apart = side * std::sin(pi / 4 - angle / 2);  // of the pulled corners, per radian
    const double expected = cloth.shear * side * std::sin(angle) * std::cos(angle) / std::sin(pi / 4 - angle / 2);
    EXPECT_NEAR(work / apart, expected, 1e-3 * expected) << degrees;
    RecordProperty("newton_at_" + std::to_string(int(degrees)) + "_degrees", std::to_string(work / apart));
  }
}

// templates/fabrics/README.md: strips hung with a load, marked in the middle.
class StripOnAHook : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(StripOnAHook, StretchesAsTheTestItsFabricWasMadeFrom) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("toile_hook_" + std::to_string(::getpid()) + ".toml");
  std::ofstream(file) << "friction = 0.4\nthickness = \"0.5 mm\"\nmost_stretch = \"9 %\"\n[test]\nweight = \"240 g/m^2\"\n"
                         "strip_width = \"5 cm\"\nwarp = \"100 g at 1.1 %\"\nweft = \"100 g at 1.9 %\"\n"
                         "bias = \"20 g at 2.1 %\"\nnarrowing = 0.25\n"
                         "bending_length_warp = \"1.9 cm\"\nbending_length_weft = \"1.7 cm\"\n";
  const auto loaded = read_fabric(file);
  std::filesystem::remove(file);
  ASSERT_TRUE(loaded.value) << in_words(loaded.report.findings.at(0));
  const auto [cut, turn] = GetParam();
  const double grams = turn == pi / 4 ? 20 : 100, stretch = turn == 0 ? .011 : turn == pi / 2 ? .019 : .021;
  const double width = .05, length = .3;
  GarmentMesh strip = crossed_sheet(width, length, 5);
  strip.panels[0].warp = Eigen::Vector2d(-std::sin(turn), std::cos(turn));
  const Eigen::Matrix2Xd& rest = strip.panels[0].rest;
  const Body body = nobody();
  fem::Model model = fem::make_model(strip, *loaded.value, body);
  // The strip weighs nothing; the load hangs evenly along its lower end.
  model.mass.setZero();
  Eigen::Matrix3Xd start(3, strip.vertex_count);
  std::vector<int> held;
  int upper = -1, lower = -1;  // marks 10 cm apart
  for (int v = 0; v < strip.vertex_count; ++v) {
    start.col(v) << rest(0, v), 5 + rest(1, v), 0;
    if (rest(1, v) > length / 2 - 1e-9) held.push_back(v);
    if (rest(1, v) < -length / 2 + 1e-9) model.mass(v) = grams * 1e-3 / 5 / (std::abs(rest(0, v)) > width / 2 - 1e-9 ? 2 : 1);
    if ((rest.col(v) - Eigen::Vector2d(.005, .05)).norm() < 1e-9) upper = v;
    if ((rest.col(v) - Eigen::Vector2d(.005, -.05)).norm() < 1e-9) lower = v;
  }
  ASSERT_GE(std::min(upper, lower), 0);
  const HeldCloth found = settle_held(model, start, held, 1e-8);
  EXPECT_LT(found.residual, 1e-6);
  EXPECT_NEAR((found.x.col(upper) - found.x.col(lower)).norm() / .1 - 1, stretch, .01 * stretch) << cut;
}

INSTANTIATE_TEST_SUITE_P(Cut, StripOnAHook,
                         testing::Values(std::pair{"warp", 0.}, std::pair{"weft", pi / 2}, std::pair{"bias", pi / 4}),
                         [](const auto& strip) { return std::string(strip.param.first); });

// A sheet held by two opposite edges nearer to each other than it is long, of cloth that hardly stretches or bends: a catenary.
// Its sag from three meshes, each with half the cells of the next, gives the order of convergence.
double sag(int cells, const Fabric& cloth) {
  const double length = .3, span = .24;
  const GarmentMesh sheet = crossed_sheet(length / 3, length, cells / 3);
  const Eigen::Matrix2Xd& rest = sheet.panels[0].rest;
  const Body body = nobody();
  const fem::Model model = fem::make_model(sheet, cloth, body);
  Eigen::Matrix3Xd start(3, sheet.vertex_count);
  std::vector<int> held;
  for (int v = 0; v < sheet.vertex_count; ++v) {
    const double t = 2 * rest(1, v) / length;
    start.col(v) << rest(0, v), 3 - .08 * (1 - t * t), t * span / 2;
    if (std::abs(t) > 1 - 1e-9) held.push_back(v);
  }
  const HeldCloth found = settle_held(model, start, held, 1e-9);
  EXPECT_LT(found.residual, 1e-7);
  double sum = 0;
  int count = 0;
  for (int v = 0; v < sheet.vertex_count; ++v)
    if (std::abs(rest(1, v)) < 1e-9) sum += 3 - found.x(1, v), ++count;
  return sum / count;
}

TEST(HangingSheet, ConvergesToTheCatenaryAtSecondOrder) {
  Fabric cloth = *read_fabric(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics/cotton_poplin.toml").value;
  cloth.bend_warp = cloth.bend_weft = 1e-8;
  cloth.bend_friction = 0;
  const double length = .3, span = .24;
  double low = .01, high = 10;  // a: length = 2 a sinh(span / 2a)
  for (int i = 0; i < 100; ++i) {
    const double a = (low + high) / 2;
    (2 * a * std::sinh(span / (2 * a)) > length ? low : high) = a;
  }
  const double catenary = low * (std::cosh(span / (2 * low)) - 1);
  const double coarse = sag(6, cloth), middle = sag(12, cloth), fine = sag(24, cloth);
  const double order = std::log2(std::abs((coarse - middle) / (middle - fine)));
  std::cout << "sag " << 1e3 * coarse << ", " << 1e3 * middle << ", " << 1e3 * fine << " mm, catenary " << 1e3 * catenary
            << " mm, order " << order << "\n";
  RecordProperty("order", std::to_string(order));
  EXPECT_GT(order, 1);
  EXPECT_NEAR(fine, catenary, .005 * catenary);
}

// Two solvers of one energy: a sheet over a rod, which has one equilibrium near by.
class SolverPair : public testing::TestWithParam<const char*> {};

TEST_P(SolverPair, DrapeTheSame) {
  const Fabric cloth =
      *read_fabric(std::filesystem::path(TOILE_SOURCE_DIR) / "templates/fabrics" / (std::string(GetParam()) + ".toml")).value;
  const Body body = bar();
  const GarmentMesh sheet = crossed_sheet(.12, .36, 6);
  const DrapeRequest request{.garment = sheet, .start = hung_over_bar(sheet), .body = body, .fabric = cloth, .tolerance = 1e-5};
  const Drape full = find_simulator("fem").drape(request), projected = find_simulator("fem-projected").drape(request);
  EXPECT_TRUE(full.settled && projected.settled) << full.residual << " " << projected.residual;
  const double apart = (full.positions - projected.positions).colwise().norm().maxCoeff();
  std::cout << GetParam() << ": " << full.steps << " and " << projected.steps << " steps, moved "
            << 1e3 * (full.positions - request.start).colwise().norm().maxCoeff() << " mm, apart " << 1e3 * apart << " mm\n";
  RecordProperty("apart_mm", std::to_string(1e3 * apart));
  EXPECT_GT((full.positions - request.start).colwise().norm().maxCoeff(), .5e-3);
  EXPECT_LT(apart, .5e-3);
}

INSTANTIATE_TEST_SUITE_P(Cloth, SolverPair, testing::Values("jersey", "silk_charmeuse", "denim", "wool_coating"));

}  // namespace
}  // namespace toile::test
