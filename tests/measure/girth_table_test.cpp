#include "measure/girth_table.h"

#include <gtest/gtest.h>

#include "measure/cloth_section.h"
#include "measure/worn_tube.h"

namespace toile {
namespace {

using test::pi;
using test::tube_of_cloth;
using test::worn_round;
using Vec = Eigen::Vector3d;

constexpr int round_cells = 72;
double polygon(double radius, int corners) { return 2 * corners * radius * std::sin(pi / corners); }

const GirthRow& row_of(const std::vector<GirthRow>& rows, const std::string& name) {
  for (const GirthRow& row : rows)
    if (row.name == name) return row;
  throw std::out_of_range(name);
}

GarmentMesh joined(const GarmentMesh& a, const GarmentMesh& b) {
  GarmentMesh both = a;
  for (std::size_t p = 0; p < b.panels.size(); ++p) {
    both.panels.push_back(b.panels[p]);
    both.welded.push_back(b.welded[p].array() + a.vertex_count);
  }
  both.triangles.resize(3, a.triangles.cols() + b.triangles.cols());
  both.triangles << a.triangles, b.triangles.array() + a.vertex_count;
  both.vertex_count = a.vertex_count + b.vertex_count;
  return both;
}

Eigen::Matrix3Xd beside(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  Eigen::Matrix3Xd both(3, a.cols() + b.cols());
  both << a, b;
  return both;
}

// `x` of a tube round the y axis, moved to lie round the line from a to b, its low end at a.
Eigen::Matrix3Xd round_line(const Eigen::Matrix3Xd& x, const Vec& a, const Vec& b) {
  return (Eigen::Quaterniond::FromTwoVectors(Vec::UnitY(), b - a).toRotationMatrix() * x).colwise() + a;
}

TEST(GirthTable, OfATubeRoundARoundBodyIsExact) {
  const Mannequin form = test::round_form(.12);
  const GarmentMesh garment = tube_of_cloth(.13, .5, round_cells, 20);
  const std::vector<GirthRow> rows = girth_table(garment, worn_round(garment, .143, .75), form);
  ASSERT_EQ(rows.size(), 3u);  // no bones: no arms, no legs
  for (const GirthRow& row : rows) {
    EXPECT_TRUE(row.covered) << row.name;
    EXPECT_NEAR(row.body, polygon(.12, 180), 1e-12);
    EXPECT_NEAR(row.garment, polygon(.143, round_cells), 1e-12);
    EXPECT_NEAR(row.cloth, polygon(.13, round_cells), 1e-12);
    EXPECT_NEAR(row.ease, row.garment - row.body, 1e-15);
    EXPECT_EQ(row.garment_height, row.height);
  }
  EXPECT_EQ(row_of(rows, "bust").height, 1.2);
}

TEST(GirthTable, SaysWhereTheGarmentDoesNotReach) {
  const Mannequin form = test::round_form(.12);
  const GarmentMesh garment = tube_of_cloth(.13, .3, round_cells, 20);
  const std::vector<GirthRow> rows = girth_table(garment, worn_round(garment, .13, .75), form);
  EXPECT_FALSE(row_of(rows, "bust").covered);
  EXPECT_EQ(row_of(rows, "bust").garment, 0);
  EXPECT_EQ(row_of(rows, "bust").ease, 0);
  EXPECT_GT(row_of(rows, "bust").body, .7);
  EXPECT_TRUE(row_of(rows, "waist").covered);
}

// Open all the way up: a gap is not covered, a lap is, and the tape goes over it.
TEST(GirthTable, AnOpenFrontCountsWhenItLaps) {
  const Mannequin form = test::round_form(.12);
  GarmentMesh garment = tube_of_cloth(.13, .5, round_cells, 20);
  const PanelMesh& panel = garment.panels[0];
  garment.triangles = panel.triangles;
  garment.vertex_count = static_cast<int>(panel.rest.cols());
  garment.welded[0] = Eigen::VectorXi::LinSpaced(panel.rest.cols(), 0, garment.vertex_count - 1);
  for (const double turns : {.98, 1.02}) {
    Eigen::Matrix3Xd x(3, garment.vertex_count);
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
      const double share = panel.rest(0, v) / panel.rest.row(0).maxCoeff(), angle = 2 * pi * turns * share;
      const double radius = .14 + .002 * share;
      x.col(v) << radius * std::sin(angle), .75 + panel.rest(1, v), radius * std::cos(angle);
    }
    const GirthRow row = row_of(girth_table(garment, x, form), "waist");
    EXPECT_EQ(row.covered, turns > 1);
    if (row.covered) {
      EXPECT_NEAR(row.garment, 2 * pi * .141, 2e-3);
      EXPECT_NEAR(row.cloth, polygon(.13, round_cells), 1e-9);
    }
  }
}

TEST(GirthTable, TakesTheInnermostLayer) {
  const Mannequin form = test::round_form(.12);
  const GarmentMesh outer = tube_of_cloth(.16, .5, round_cells, 20), lining = tube_of_cloth(.13, .5, round_cells, 20);
  const auto x = beside(worn_round(outer, .16, .75), worn_round(lining, .13, .75));
  EXPECT_NEAR(row_of(girth_table(joined(outer, lining), x, form), "waist").garment, polygon(.13, round_cells), 1e-12);
}

TEST(GirthTable, ADentIsSpannedByTheTapeButCountsAsCloth) {
  const Mannequin form = test::round_form(.12);
  const GarmentMesh garment = tube_of_cloth(.15, .5, round_cells, 20);
  Eigen::Matrix3Xd x = worn_round(garment, .15, .75);
  const double taut = row_of(girth_table(garment, x, form), "waist").garment;
  for (Eigen::Index v = 0; v < x.cols(); ++v)
    if (x(2, v) > .145) x(2, v) = .125;  // a fold pushed in at the front
  const GirthRow row = row_of(girth_table(garment, x, form), "waist");
  EXPECT_LT(row.garment, taut);
  EXPECT_GT(row.garment, .98 * taut);
  EXPECT_NEAR(row.cloth, taut, 1e-9);
}

// A body of cylinders with bones: trunk, arms out and down, two legs.
struct Figure {
  Mannequin form;
  Vec shoulder{.18, 1.36, 0}, hand{.60, .94, 0};
};

Figure figure() {
  Figure made;
  std::vector<test::Closed> parts = {test::cylinder({0, .75, 0}, {0, 1.5, 0}, .14, 72)};
  const Vec mirror(-1, 1, 1);
  for (const Vec& side : {Vec(1, 1, 1), mirror}) {
    parts.push_back(test::cylinder(made.shoulder.cwiseProduct(side), made.hand.cwiseProduct(side), .045, 72));
    parts.push_back(test::cylinder(Vec(.09, .05, 0).cwiseProduct(side), Vec(.09, .8, 0).cwiseProduct(side), .075, 72));
  }
  Mannequin& form = made.form;
  for (const test::Closed& part : parts) {
    const Eigen::Index points = form.positions.cols(), faces = form.triangles.cols();
    form.positions.conservativeResize(3, points + part.positions.cols());
    form.positions.rightCols(part.positions.cols()) = part.positions;
    form.triangles.conservativeResize(3, faces + part.triangles.cols());
    form.triangles.rightCols(part.triangles.cols()) = part.triangles.array() + static_cast<int>(points);
  }
  form.height = 1.7;
  form.landmarks = {{"bust", 1.2}, {"waist", 1.05}, {"hip", .88}, {"crotch", .76}};
  for (const std::string name : {".L", ".R"}) {
    const Vec side = name == ".L" ? Vec(1, 1, 1) : mirror;
    const auto add = [&](const std::string& bone, const Vec& from, const Vec& to) {
      form.bones.push_back({bone + name, "", from.cwiseProduct(side), to.cwiseProduct(side)});
    };
    const Vec elbow = (made.shoulder + made.hand) / 2;
    add("upperarm", made.shoulder, elbow);
    add("forearm", elbow, made.hand);
    add("thigh", {.09, .85, 0}, {.09, .45, 0});
    add("shin", {.09, .45, 0}, {.09, .05, 0});
  }
  form.bones.push_back({"chest", "", {0, .9, 0}, {0, 1.5, 0}});
  return made;
}

TEST(GirthTable, OfSleevesAndTrouserLegsIsTakenRoundEachLimb) {
  const Figure f = figure();
  const GarmentMesh sleeve = tube_of_cloth(.06, .3, round_cells, 20), leg = tube_of_cloth(.085, .7, round_cells, 20);
  const auto x =
      beside(round_line(worn_round(sleeve, .06, 0), f.shoulder, f.hand), worn_round(leg, .085, .06, 1, {-.09, 0, 0}));
  const std::vector<GirthRow> rows = girth_table(joined(sleeve, leg), x, f.form);
  ASSERT_EQ(rows.size(), 7u);
  const GirthRow biceps = row_of(rows, "biceps.L"), thigh = row_of(rows, "thigh.R");
  EXPECT_TRUE(biceps.covered);
  EXPECT_NEAR(biceps.garment, polygon(.06, round_cells), 1e-9);
  EXPECT_NEAR(biceps.body, polygon(.045, 72), 1e-9);
  EXPECT_NEAR(biceps.height, 1.36 - .55 * .21, 1e-12);
  EXPECT_TRUE(thigh.covered);
  EXPECT_NEAR(thigh.garment, polygon(.085, round_cells), 1e-9);
  EXPECT_NEAR(thigh.body, polygon(.075, 72), 1e-9);
  EXPECT_NEAR(thigh.height, .74, 1e-12);
  for (const char* bare : {"biceps.R", "thigh.L", "bust", "waist", "hip"}) EXPECT_FALSE(row_of(rows, bare).covered) << bare;
}

// A skirt goes round both legs and a cape round trunk and arms: neither is the girth of one of them.
TEST(GirthTable, SkirtsAndCapesAreNotTheGirthOfOneLimb) {
  const Figure f = figure();
  const GarmentMesh skirt = tube_of_cloth(.22, .5, round_cells, 20), cape = tube_of_cloth(.7, .4, round_cells, 20);
  const auto x = beside(worn_round(skirt, .22, .5), worn_round(cape, .7, .95));
  const std::vector<GirthRow> rows = girth_table(joined(skirt, cape), x, f.form);
  EXPECT_TRUE(row_of(rows, "hip").covered);
  EXPECT_NEAR(row_of(rows, "hip").garment, polygon(.22, round_cells), 1e-9);
  for (const char* other : {"thigh.L", "thigh.R", "bust", "waist", "biceps.L"})
    EXPECT_FALSE(row_of(rows, other).covered) << other;
}

// A cape to just below the bust over a dress: the chest is taped where nothing but the dress goes round.
TEST(GirthTable, TapesLowerWhereTheArmsArePartOfTheSectionAtTheBust) {
  const Figure f = figure();
  const GarmentMesh batwing = tube_of_cloth(.5, .4, round_cells, 20), dress = tube_of_cloth(.16, .4, round_cells, 20);
  const auto x = beside(worn_round(batwing, .5, 1.172), worn_round(dress, .16, 1.178 - .4));
  const GirthRow bust = row_of(girth_table(joined(batwing, dress), x, f.form), "bust");
  EXPECT_TRUE(bust.covered);
  EXPECT_NEAR(bust.garment, polygon(.16, round_cells), 1e-9);
  EXPECT_NEAR(bust.garment_height, 1.175, 1e-9);
  EXPECT_EQ(bust.height, 1.2);
}

TEST(ClothSections, AreFoundPartByPart) {
  const GarmentMesh tube = tube_of_cloth(.1, .3, 48, 10);
  const GarmentMesh two = joined(tube, tube);
  const auto x = beside(worn_round(tube, .1, 0, 1, {.5, 0, 0}), worn_round(tube, .1, 0, 1, {-.5, 0, 0}));
  const auto sections = cloth_sections(two, x, {0, .1, 0}, Vec::UnitY());
  ASSERT_EQ(sections.size(), 2u);
  for (const ClothSection& section : sections) EXPECT_NEAR(section.at_rest, polygon(.1, 48), 1e-12);
  EXPECT_TRUE(goes_round(sections[0], {.52, .1, .03}, Vec::UnitY()));
  EXPECT_FALSE(goes_round(sections[0], {.7, .1, 0}, Vec::UnitY()));
  EXPECT_FALSE(goes_round(sections[0], {-.5, .1, 0}, Vec::UnitY()));
  EXPECT_TRUE(cloth_sections(two, x, {0, .4, 0}, Vec::UnitY()).empty());
  EXPECT_THROW(girth_row({"waist", {0, .1, 0}}, two, x.leftCols(3), figure().form), std::invalid_argument);
}

}  // namespace
}  // namespace toile
