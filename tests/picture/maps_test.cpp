#include "picture/maps.h"

#include <gtest/gtest.h>

#include <cmath>

#include "picture/colour_space.h"
#include "picture/page.h"
#include "picture/worn.h"

namespace toile {
namespace {

using test::Worn;
using test::worn;

GarmentMap of_vertices(const Worn& w, double value) {
  return {.name = "ease",
          .title = "ease",
          .unit = "mm",
          .unit_size = 1e-3,
          .values = Eigen::VectorXd::Constant(w.garment.vertex_count, value)};
}

GarmentMap of_triangles(const Worn& w, double value) {
  return {.name = "stretch",
          .title = "stretch along the warp",
          .unit = "%",
          .unit_size = .01,
          .is_signed = true,
          .of = MapOf::triangle,
          .least_top = .01,
          .values = Eigen::VectorXd::Constant(w.garment.triangles.cols(), value)};
}

bool near(const Colour& a, const Colour& b, double by) {
  return std::abs(a.red - b.red) < by && std::abs(a.green - b.green) < by && std::abs(a.blue - b.blue) < by;
}

TEST(SignedColourMap, GetsDarkerBothWaysEvenlyAndApart) {
  for (const double side : {-1., 1.}) {
    double before = to_oklab(signed_colour_map(0)).lightness;
    for (int i = 1; i <= 12; ++i) {
      const double lightness = to_oklab(signed_colour_map(side * i / 12)).lightness;
      EXPECT_GT(before - lightness, .025) << side * i;
      EXPECT_LT(before - lightness, .065) << side * i;
      before = lightness;
    }
  }
  // Without red and green, blue and yellow are left to tell stretched from pushed together.
  for (const double t : {.25, .5, .75, 1.}) EXPECT_GT(to_oklab(signed_colour_map(t)).b - to_oklab(signed_colour_map(-t)).b, .1);
  EXPECT_EQ(signed_colour_map(9), signed_colour_map(1));
  EXPECT_EQ(signed_colour_map(NAN), (Colour{.5, .5, .5}));
}

TEST(MapScale, IsRoundWithinTheMapsLimitsAndCommonToAll) {
  const Worn w = worn();
  EXPECT_EQ(map_scale({of_vertices(w, .0073)}), (MapScale{0, .008}));
  const MapScale stretch = map_scale({of_triangles(w, .021), of_triangles(w, -.047)});
  EXPECT_NEAR(stretch.high, .05, 1e-15);
  EXPECT_EQ(stretch.low, -stretch.high);
  EXPECT_NEAR(map_scale({of_triangles(w, 1e-4)}).high, .01, 1e-15);
  GarmentMap far = of_vertices(w, .5);
  far.most_top = .06;
  EXPECT_NEAR(map_scale({far}).high, .06, 1e-15);
  GarmentMap none = of_vertices(w, NAN);
  none.values(3) = .002;
  EXPECT_NEAR(map_scale({none}).high, .002, 1e-15);
  EXPECT_THROW(map_scale({}), std::invalid_argument);
  EXPECT_THROW(map_scale({of_vertices(w, 1), of_triangles(w, 1)}), std::invalid_argument);
}

TEST(MapPicture, ShowsTheColoursAndTheirLegendAtEveryWidth) {
  const Worn w = worn();
  const Showing showing{w.body, w.garment, {}, 1};
  const MapScale scale{-.05, .05};
  for (const int width : {480, 900, 1500}) {
    const Image wide = map_picture(showing, w.drape, coloured(of_triangles(w, .05), scale), "wide", width);
    const Image tight = map_picture(showing, w.drape, coloured(of_triangles(w, -.05), scale), "tight", width);
    EXPECT_EQ(wide.width, width);
    for (const int view : {1, 3, 5}) {
      EXPECT_GT(pixel(wide, view * width / 6, wide.height / 3).red, .3) << width;
      EXPECT_LT(pixel(wide, view * width / 6, wide.height / 3).blue, .2) << width;
      EXPECT_GT(pixel(tight, view * width / 6, wide.height / 3).blue, .3) << width;
      EXPECT_LT(pixel(tight, view * width / 6, wide.height / 3).red, .2) << width;
    }
    const int bar = wide.height - 104 + 39;
    EXPECT_TRUE(near(pixel(wide, width / 4 + 2, bar), signed_colour_map(-1), .03));
    EXPECT_TRUE(near(pixel(wide, width / 2, bar), signed_colour_map(0), .03));
    EXPECT_TRUE(near(pixel(wide, 3 * width / 4 - 3, bar), signed_colour_map(1), .03));
  }
}

TEST(MapPicture, RefusesAMapOfAnotherGarment) {
  const Worn w = worn();
  const Showing showing{w.body, w.garment, {}, 1};
  GarmentMap few = of_vertices(w, 1);
  few.values = Eigen::VectorXd::Zero(3);
  EXPECT_THROW(map_picture(showing, w.drape, coloured(few, {0, 1}), ""), std::invalid_argument);
  EXPECT_THROW(map_picture(showing, w.drape, coloured(of_vertices(w, 1), {0, 1}), "", 200), std::invalid_argument);
  EXPECT_THROW(coloured(of_vertices(w, 1), {0, 0}), std::invalid_argument);
}

TEST(FigureWords, HaveAsManyDigitsAsTheStepsNeed) {
  EXPECT_EQ(figure_words(20, 20), "20");
  EXPECT_EQ(figure_words(.5, .1), "0.5");
  EXPECT_EQ(figure_words(.015, .005), "0.015");
  EXPECT_EQ(figure_words(-2, 1), "\u22122");
  EXPECT_EQ(figure_words(-.0001, .1), "0.0");
}

}  // namespace
}  // namespace toile
