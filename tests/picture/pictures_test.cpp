#include "picture/pictures.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture/worn.h"

namespace toile {
namespace {

using test::Worn;
using test::worn;

bool near(const Colour& a, const Colour& b, double by) {
  return std::abs(a.red - b.red) < by && std::abs(a.green - b.green) < by && std::abs(a.blue - b.blue) < by;
}

TEST(Pictures, ShowTheDrapeFromThreeSides) {
  const Worn w = worn();
  const Image image = drape_picture({w.body, w.garment, {}, 1}, w.drape, "a tube");
  EXPECT_EQ(image.width, 1200);
  for (const int x : {200, 600, 1000}) {
    const Colour cloth = pixel(image, x, image.height / 2);
    EXPECT_GT(cloth.blue, cloth.red + .1) << x;
  }
}

TEST(Pictures, DistancesAreColouredAndExplained) {
  const Worn w = worn();
  Eigen::VectorXd none = Eigen::VectorXd::Zero(w.drape.cols()), far = none;
  far.setConstant(.02);
  const Showing showing{w.body, w.garment, {}, 1};
  const Image pale = distance_picture(showing, {w.drape, none, "nothing"}, .01);
  const Image deep = distance_picture(showing, {w.drape, far, "far"}, .01);
  EXPECT_TRUE(near(pixel(pale, 200, 250), colour_map(0), .2));
  EXPECT_TRUE(near(pixel(deep, 200, 250), colour_map(1), .2));
  const int bar = pale.height - 84 + 39;  // the scale below the views
  EXPECT_TRUE(near(pixel(pale, 302, bar), colour_map(0.003), .02));
  EXPECT_TRUE(near(pixel(pale, 600, bar), colour_map(0.5), .02));
  EXPECT_TRUE(near(pixel(pale, 897, bar), colour_map(0.997), .02));
}

TEST(Pictures, ComparesTwoDrapesOnOneScale) {
  const Worn w = worn();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(w.drape.cols());
  const Eigen::VectorXd far = Eigen::VectorXd::Constant(w.drape.cols(), .01);
  const Image image = compared_picture({w.body, w.garment, {}, 1}, {w.drape, far, "left"}, {w.drape, none, "right"}, .01);
  EXPECT_EQ(image.width, 1200);
  for (const int x : {150, 450}) EXPECT_TRUE(near(pixel(image, x, 200), colour_map(1), .2));
  for (const int x : {750, 1050}) EXPECT_TRUE(near(pixel(image, x, 200), colour_map(0), .2));
}

TEST(Pictures, ScaleCoversNearlyAll) {
  EXPECT_DOUBLE_EQ(scale_top({Eigen::VectorXd::Constant(10, .0034)}), .004);
  EXPECT_DOUBLE_EQ(scale_top({Eigen::VectorXd::Constant(10, 1e-5)}), .001);
  EXPECT_DOUBLE_EQ(scale_top({}), .001);
  Eigen::VectorXd one_out = Eigen::VectorXd::Constant(1000, .002);
  one_out[7] = .3;
  EXPECT_DOUBLE_EQ(scale_top({one_out}), .002);
}

TEST(Pictures, RefuseWrongNumbers) {
  const Worn w = worn();
  const Showing showing{w.body, w.garment, {}, 1};
  const Eigen::VectorXd few = Eigen::VectorXd::Zero(3), right = Eigen::VectorXd::Zero(w.drape.cols());
  EXPECT_THROW(distance_picture(showing, {w.drape, few, ""}, .01), std::invalid_argument);
  EXPECT_THROW(distance_picture(showing, {w.drape, right, ""}, 0), std::invalid_argument);
  EXPECT_THROW(drape_picture(showing, w.drape.leftCols(5), ""), std::invalid_argument);
}

GarmentMesh flat_panel() {
  GarmentMesh garment;
  PanelMesh panel;
  panel.name = "gore:1";
  panel.rest.resize(2, 4);
  panel.rest << -.1, .1, .05, -.05, 0, 0, .6, .6;
  for (int i = 0; i < 4; ++i) panel.boundary.push_back({i, i, 0});
  garment.panels = {panel, panel};
  garment.panels[1].name = "gore:2";
  return garment;
}

TEST(PanelOutlines, TurnBackAndLieOnTheEndThatStayed) {
  const GarmentMesh garment = flat_panel();
  RestShape shorter = rest_shape(garment);
  for (Eigen::Matrix2Xd& rest : shorter) rest(1, 0) = rest(1, 1) = .1;
  Eigen::Matrix2d turn;
  turn << std::cos(1), -std::sin(1), std::sin(1), std::cos(1);
  RestShape turned = shorter;
  for (Eigen::Matrix2Xd& rest : turned) rest = (turn * rest).colwise() + Eigen::Vector2d(3, 4);
  const std::vector<PanelOutlines> outlines = panel_outlines(garment, turned, shorter);
  ASSERT_EQ(outlines.size(), 1u);
  EXPECT_EQ(outlines[0].name, "gore");
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR((outlines[0].flattened[i] - shorter[0].col(static_cast<Eigen::Index>(i))).norm(), 0, 1e-9);
    EXPECT_NEAR((outlines[0].adjusted[i] - shorter[0].col(static_cast<Eigen::Index>(i))).norm(), 0, 1e-9);
  }
  EXPECT_THROW(panel_outlines(garment, {}, shorter), std::invalid_argument);
}

TEST(PanelOutlines, ABentBandLiesAcrossTheStraightOne) {
  GarmentMesh garment;
  PanelMesh band;
  band.name = "band";
  const int n = 20;
  band.rest.resize(2, 2 * (n + 1));
  RestShape bent{Eigen::Matrix2Xd(2, 2 * (n + 1))};
  for (int i = 0; i <= n; ++i) {
    const double x = .7 * i / n, sag = .1 * (x - .35) * (x - .35);
    band.rest.col(i) << x, 0;
    band.rest.col(2 * n + 1 - i) << x, .04;
    bent[0].col(i) << x, sag;
    bent[0].col(2 * n + 1 - i) << x, .04 + sag;
  }
  for (int i = 0; i < 2 * (n + 1); ++i) band.boundary.push_back({i, 0, 0});
  garment.panels = {band};
  const PanelOutlines outlines = panel_outlines(garment, bent, bent).at(0);
  for (const Eigen::Vector2d& p : outlines.flattened) EXPECT_LT(std::abs(p.y() - (p.y() > .02 ? .04 : 0)), .013);
}

TEST(PanelsOverlay, DrawsEachStageInItsColour) {
  const PanelOutlines panel{"p",
                            {{0, 0}, {.4, 0}, {.4, .4}, {0, .4}},
                            {{.05, .05}, {.35, .05}, {.35, .35}, {.05, .35}},
                            {{.1, .1}, {.3, .1}, {.3, .3}, {.1, .3}}};
  const Image image = panels_overlay({panel}, "three squares", 900);
  int green = 0, red = 0, blue = 0;
  int green_left = image.width, red_left = image.width, blue_left = image.width;
  for (int y = 110; y < image.height - 100; ++y)
    for (int x = 0; x < image.width; ++x) {
      const Colour c = pixel(image, x, y);
      if (c.green > c.red + .3 && c.green > c.blue + .2) ++green, green_left = std::min(green_left, x);
      if (c.red > c.green + .5 && c.red > c.blue + .5) ++red, red_left = std::min(red_left, x);
      if (c.blue > c.green + .3 && c.blue > c.red + .4) ++blue, blue_left = std::min(blue_left, x);
    }
  for (const int count : {green, red, blue}) EXPECT_GT(count, 500);
  EXPECT_LT(green_left, red_left);
  EXPECT_LT(red_left, blue_left);
  EXPECT_NEAR(blue_left - red_left, red_left - green_left, 3);
  EXPECT_THROW(panels_overlay({}, ""), std::invalid_argument);
}

}  // namespace
}  // namespace toile
